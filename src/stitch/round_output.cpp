#include "stitch/round_output.hpp"

#include "base/memory_shares.hpp"
#include "io/sorted_list.hpp"
#include "io/spool_records.hpp"
#include "mesh/ordered_face.hpp"

#include <algorithm>
#include <array>
#include <map>
#include <span>
#include <utility>

namespace winnow {

std::array<float, 3> normal_along(const Point& sum) {
  const double size = length(sum);
  if (!(size > 0)) return {};
  return {static_cast<float>(sum[0] / size), static_cast<float>(sum[1] / size),
          static_cast<float>(sum[2] / size)};
}

TileResult rest_of(const Tile& tile, const TileMesh& mesh, const Decimation& decimation,
                   const CarriedValues& values, CollapsedInto* into, std::size_t state_size) {
  TileResult rest;
  std::vector<std::uint8_t> has_faces(mesh.vertex_count(), 0);
  std::vector<Point> normals(mesh.vertex_count(), Point{});
  for (FaceNumber f = 0; f < mesh.face_count(); ++f) {
    if (mesh.removed(f)) continue;
    const Point normal = doubled_area(mesh.triangle(f));
    for (const VertexNumber v : mesh.face(f)) {
      has_faces[v] = 1;
      normals[v] = normals[v] + normal;
    }
  }
  const auto left = static_cast<std::size_t>(
      std::count(has_faces.begin(), has_faces.begin() + tile.own_vertices, 1));
  const std::size_t most = left + tile.hubs.size();
  rest.vertices.reserve(most);
  rest.state.reserve(most * state_size);
  std::vector<std::uint32_t> place(tile.own_vertices, no_number);
  for (VertexNumber v = 0; v < tile.own_vertices; ++v) {
    const bool hub = std::binary_search(tile.hubs.begin(), tile.hubs.end(), v);
    // The faces of a hub may all be other tiles'.
    if (has_faces[v] == 0 && !hub) continue;
    place[v] = static_cast<std::uint32_t>(rest.vertices.size());
    IndexedVertex vertex = tile.vertices[v];
    vertex.position = mesh.position(v);
    vertex.normal = normal_along(normals[v]);
    rest.vertices.push_back(vertex);
    rest.state.resize(rest.state.size() + state_size);
    decimation.save(v, rest.state.data() + rest.state.size() - state_size);
    const std::span<const double> carried = values.of(v);
    rest.attributes.insert(rest.attributes.end(), carried.begin(), carried.end());
    if (mesh.locked(v) || hub)
      rest.named.push_back({static_cast<std::uint32_t>(tile.first_vertex + v), place[v]});
  }
  for (FaceNumber f = 0; f < tile.own_faces; ++f) {
    if (mesh.removed(f)) continue;
    const FaceVertices& face = mesh.face(f);
    SeamFace seam{{}, 0};
    bool hub = false;
    for (std::size_t i = 0; i < 3; ++i) {
      hub |= std::binary_search(tile.hubs.begin(), tile.hubs.end(), face[i]);
      if (face[i] < tile.own_vertices) {
        seam.vertices[i] = place[face[i]];
      } else {
        seam.vertices[i] = tile.others[face[i] - tile.own_vertices];
        seam.old_mask |= 1U << i;
      }
    }
    if (hub) {
      rest.hub_faces.push_back(seam);
    } else if (seam.old_mask != 0) {
      rest.seam_faces.push_back(seam);
    } else {
      rest.faces.push_back(lowest_first(seam.vertices));
    }
  }
  std::sort(rest.faces.begin(), rest.faces.end());
  rest.changes = decimation.changes();
  for (VertexNumber v = 0; into != nullptr && v < tile.own_vertices; ++v) {
    const VertexNumber last = into->of(v);
    if (last < tile.own_vertices) {
      rest.destinations.push_back({place[last], 0});
    } else {
      rest.destinations.push_back({tile.others[last - tile.own_vertices], 1});
    }
  }
  return rest;
}

RoundOutput::RoundOutput(Job& job, const MeshLayout& layout, bool map, std::uint64_t memory)
    : job_(job),
      memory_(memory),
      out_(job, layout, MeshMemory::divide(share::round::mesh(memory))),
      faces_(job, share::round::inner_faces(memory)),
      seam_faces_(job, share::round::seam_faces(memory)),
      hub_faces_(job, share::round::hub_faces(memory)),
      named_(job, share::round::named(memory)) {
  if (map) destinations_ = std::make_unique<Spool>(job, share::round::map(memory));
}

void RoundOutput::append(TileResult rest) {
  const auto base = static_cast<std::uint32_t>(first_vertex_.back());
  for (FaceVertices& face : rest.faces) {
    for (std::uint32_t& v : face) v += base;
  }
  for (std::vector<SeamFace>* faces : {&rest.seam_faces, &rest.hub_faces}) {
    for (SeamFace& face : *faces) {
      for (std::size_t i = 0; i < 3; ++i) {
        if ((face.old_mask >> i & 1) == 0) face.vertices[i] += base;
      }
    }
  }
  for (TileDestination& to : rest.destinations) {
    if (to.is_hub == 0 && to.number != nowhere) to.number += base;
  }
  if (destinations_ != nullptr) append_records<TileDestination>(*destinations_, rest.destinations);
  out_.append_vertices(rest.vertices, rest.state, rest.attributes);
  out_.face_count += rest.faces.size() + rest.seam_faces.size() + rest.hub_faces.size();
  append_records<FaceVertices>(faces_, rest.faces);
  append_records<SeamFace>(seam_faces_, rest.seam_faces);
  append_records<SeamFace>(hub_faces_, rest.hub_faces);
  append_records<NamedVertex>(named_, rest.named);
  first_vertex_.push_back(first_vertex_.back() + rest.vertices.size());
  first_named_.push_back(first_named_.back() + rest.named.size());
}

std::uint32_t RoundOutput::new_number(const Tiling& tiling, RecentBlocks& named,
                                      std::uint32_t old_number) const {
  const std::size_t tile = tiling.tile_of(old_number);
  std::uint64_t low = first_named_[tile];
  std::uint64_t high = first_named_[tile + 1];
  NamedVertex found{};
  while (low < high) {
    const std::uint64_t middle = low + (high - low) / 2;
    found = named.at<NamedVertex>(middle);
    if (found.old_number == old_number) break;
    if (found.old_number < old_number) {
      low = middle + 1;
    } else {
      high = middle;
    }
  }
  return static_cast<std::uint32_t>(first_vertex_[tile] + found.place);
}

void RoundOutput::finish_map(const Tiling& tiling, RecentBlocks& named) {
  destinations_->finish();
  out_.map = std::make_unique<Spool>(job_, share::round::map(memory_));
  SpoolCursor<TileDestination> destinations(job_, *destinations_);
  Appender<Destination> append(job_, *out_.map);
  for (TileDestination to{}; destinations.next(to);)
    append.add(to.is_hub != 0 ? new_number(tiling, named, to.number) : to.number);
  append.flush();
  out_.map->finish();
  destinations_.reset();
}

void RoundOutput::set_normals(const std::map<std::uint32_t, Point>& normals) {
  const std::unique_ptr<VertexIndex> before = std::exchange(
      out_.vertices, std::make_unique<VertexIndex>(job_, share::round::hub_normals(memory_)));
  SpoolCursor<IndexedVertex> vertices(job_, before->records());
  Appender<IndexedVertex, VertexIndex> append(job_, *out_.vertices);
  std::uint32_t number = 0;
  for (IndexedVertex vertex; vertices.next(vertex); ++number) {
    const auto found = normals.find(number);
    if (found != normals.end()) vertex.normal = normal_along(found->second);
    append.add(vertex);
  }
  append.flush();
  out_.vertices->finish();
}

StoredMesh RoundOutput::finish(const Tiling& tiling, const std::vector<std::uint32_t>& hubs) {
  out_.finish_vertices();
  faces_.finish();
  seam_faces_.finish();
  hub_faces_.finish();
  named_.finish();
  RecentBlocks named(named_, sizeof(NamedVertex));
  if (destinations_ != nullptr) finish_map(tiling, named);
  const auto renumbered = [&](SeamFace face) {
    for (std::size_t i = 0; i < 3; ++i) {
      if ((face.old_mask >> i & 1) != 0)
        face.vertices[i] = new_number(tiling, named, face.vertices[i]);
    }
    return face.vertices;
  };
  std::map<std::uint32_t, Point> normals;  // of hubs
  for (const std::uint32_t hub : hubs) normals[new_number(tiling, named, hub)] = {};
  SortedRuns<OrderedFace> runs(job_);
  SortedList<OrderedFace> list(job_, share::round::sorted_hub_faces(memory_), runs);
  SpoolCursor<SeamFace> at_hubs(job_, hub_faces_);
  VertexIndex::Reader vertices(*out_.vertices);
  for (SeamFace face{}; at_hubs.next(face);) {
    const FaceVertices corners = lowest_first(renumbered(face));
    list.add({corners});
    const Triangle triangle{vertices.at(corners[0]).position, vertices.at(corners[1]).position,
                            vertices.at(corners[2]).position};
    for (const std::uint32_t v : corners) {
      const auto found = normals.find(v);
      if (found != normals.end()) found->second = found->second + doubled_area(triangle);
    }
  }
  list.sort();
  MergedCursor<OrderedFace> hub_faces = merge<OrderedFace>({&list}, runs);

  // All kinds of faces are in the order of their lowest vertices.
  SpoolCursor<FaceVertices> inner(job_, faces_);
  SpoolCursor<SeamFace> seams(job_, seam_faces_);
  constexpr FaceVertices none{no_number, no_number, no_number};
  const auto next_inner = [&] {
    FaceVertices face{};
    return inner.next(face) ? face : none;
  };
  const auto next_seam = [&] {
    SeamFace face{};
    return seams.next(face) ? renumbered(face) : none;
  };
  const auto next_at_hub = [&] {
    OrderedFace face{};
    return hub_faces.next(face) ? face.vertices : none;
  };
  std::array<FaceVertices, 3> next{next_inner(), next_seam(), next_at_hub()};
  Appender<FaceVertices> append(job_, *out_.faces);
  for (;;) {
    std::size_t first = 0;
    for (std::size_t i = 1; i < 3; ++i) {
      if (next[i][0] < next[first][0]) first = i;
    }
    if (next[first][0] == no_number) break;
    append.add(next[first]);
    next[first] = first == 0 ? next_inner() : first == 1 ? next_seam() : next_at_hub();
  }
  append.flush();
  out_.finish_faces();
  if (!hubs.empty()) set_normals(normals);
  return std::move(out_);
}

}  // namespace winnow
