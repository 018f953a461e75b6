#include "stitch/smaller_mesh.hpp"

#include "io/spool_records.hpp"

#include <algorithm>
#include <span>
#include <utility>

namespace winnow {

namespace {

std::array<float, 3> normal_of(const TileMesh& mesh, VertexNumber v) {
  Point sum{};
  mesh.for_each_face(v, [&](FaceNumber f) { sum = sum + doubled_area(mesh.triangle(f)); });
  const double size = length(sum);
  if (!(size > 0)) return {};
  return {static_cast<float>(sum[0] / size), static_cast<float>(sum[1] / size),
          static_cast<float>(sum[2] / size)};
}

}  // namespace

TileRest rest_of(const Tile& tile, const TileMesh& mesh, const Decimation& decimation,
                 const CarriedValues& values, std::size_t state_size) {
  TileRest rest;
  std::vector<std::uint32_t> place(tile.own_vertices, no_number);
  for (VertexNumber v = 0; v < tile.own_vertices; ++v) {
    if (!mesh.has_faces(v)) continue;
    place[v] = static_cast<std::uint32_t>(rest.vertices.size());
    IndexedVertex vertex = tile.vertices[v];
    vertex.position = mesh.position(v);
    vertex.normal = normal_of(mesh, v);
    rest.vertices.push_back(vertex);
    rest.state.resize(rest.state.size() + state_size);
    decimation.save(v, rest.state.data() + rest.state.size() - state_size);
    const std::span<const double> carried = values.of(v);
    rest.attributes.insert(rest.attributes.end(), carried.begin(), carried.end());
    if (mesh.locked(v)) rest.named.push_back({static_cast<std::uint32_t>(tile.first_vertex + v), place[v]});
  }
  for (FaceNumber f = 0; f < tile.own_faces; ++f) {
    if (mesh.removed(f)) continue;
    const FaceVertices& face = mesh.face(f);
    SeamFace seam{{}, 0};
    for (std::size_t i = 0; i < 3; ++i) {
      if (face[i] < tile.own_vertices) {
        seam.vertices[i] = place[face[i]];
      } else {
        seam.vertices[i] = tile.others[face[i] - tile.own_vertices];
        seam.old_mask |= 1U << i;
      }
    }
    if (seam.old_mask != 0) {
      rest.seam_faces.push_back(seam);
    } else {
      rest.faces.push_back(lowest_first(seam.vertices));
    }
  }
  std::sort(rest.faces.begin(), rest.faces.end());
  return rest;
}

SmallerMesh::SmallerMesh(Job& job, std::size_t state_size, std::size_t attributes, std::uint64_t memory)
    : job_(job),
      memory_(memory),
      faces_(job, memory / 8),
      seam_faces_(job, memory / 16),
      named_(job, memory / 16) {
  out_.mesh.vertices = std::make_unique<VertexIndex>(job, memory / 4);
  std::uint64_t left = memory / 4;
  if (attributes > 0) {
    const std::uint64_t bytes = attributes * sizeof(double);
    const std::uint64_t share = left / (state_size + bytes) * bytes;
    out_.mesh.attributes = std::make_unique<Spool>(job, share);
    left -= share;
  }
  if (state_size > 0) out_.state = std::make_unique<Spool>(job, left);
}

void SmallerMesh::append(TileRest rest) {
  const auto base = static_cast<std::uint32_t>(first_vertex_.back());
  for (FaceVertices& face : rest.faces) {
    for (std::uint32_t& v : face) v += base;
  }
  for (SeamFace& face : rest.seam_faces) {
    for (std::size_t i = 0; i < 3; ++i) {
      if ((face.old_mask >> i & 1) == 0) face.vertices[i] += base;
    }
  }
  out_.mesh.vertices->append(rest.vertices);
  if (out_.state != nullptr) out_.state->append(rest.state);
  if (out_.mesh.attributes != nullptr)
    out_.mesh.attributes->append(std::as_bytes(std::span(rest.attributes)));
  out_.mesh.face_count += rest.faces.size() + rest.seam_faces.size();
  append_records<FaceVertices>(faces_, rest.faces);
  append_records<SeamFace>(seam_faces_, rest.seam_faces);
  append_records<NamedVertex>(named_, rest.named);
  first_vertex_.push_back(first_vertex_.back() + rest.vertices.size());
  first_named_.push_back(first_named_.back() + rest.named.size());
}

std::uint32_t SmallerMesh::new_number(const Tiling& tiling, RecentBlocks& named,
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

RefinedMesh SmallerMesh::finish(const Tiling& tiling) {
  out_.mesh.vertices->finish();
  if (out_.state != nullptr) out_.state->finish();
  if (out_.mesh.attributes != nullptr) out_.mesh.attributes->finish();
  faces_.finish();
  seam_faces_.finish();
  named_.finish();
  // Both kinds of faces are in the order of their lowest vertices.
  out_.mesh.faces = std::make_unique<Spool>(job_, memory_ / 4);
  SpoolCursor<FaceVertices> inner(job_, faces_);
  SpoolCursor<SeamFace> seams(job_, seam_faces_);
  RecentBlocks named(named_, sizeof(NamedVertex));
  FaceVertices face{};
  SeamFace seam{};
  bool more_inner = inner.next(face);
  bool more_seams = seams.next(seam);
  Appender<FaceVertices> append(job_, *out_.mesh.faces);
  while (more_inner || more_seams) {
    if (more_inner && (!more_seams || face[0] <= seam.vertices[0])) {
      append.add(face);
      more_inner = inner.next(face);
    } else {
      for (std::size_t i = 0; i < 3; ++i) {
        if ((seam.old_mask >> i & 1) != 0) seam.vertices[i] = new_number(tiling, named, seam.vertices[i]);
      }
      append.add(seam.vertices);
      more_seams = seams.next(seam);
    }
  }
  append.flush();
  out_.mesh.faces->finish();
  return std::move(out_);
}

}  // namespace winnow
