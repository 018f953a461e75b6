#include "stitch/tile.hpp"

#include "base/hash.hpp"
#include "base/memory_shares.hpp"
#include "base/sort_unique.hpp"
#include "io/recent_blocks.hpp"
#include "io/sorted_records.hpp"
#include "io/spool_records.hpp"
#include "stitch/round_output.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <map>
#include <span>
#include <utility>

namespace winnow {

namespace {

// In the order of tiles; of each its own first.
struct ListedFace {
  std::uint32_t list;
  FaceVertices vertices;

  static bool before(const ListedFace& a, const ListedFace& b) {
    return a.list != b.list ? a.list < b.list : a.vertices < b.vertices;
  }
  static bool combine(ListedFace&, const ListedFace&) { return false; }
};

std::uint32_t adopted_list(std::size_t tile) {
  return static_cast<std::uint32_t>(2 * tile);
}
std::uint32_t incoming_list(std::size_t tile) {
  return static_cast<std::uint32_t>(2 * tile + 1);
}

// each(face) for the faces with corners in several tiles.
template <typename Each>
void for_each_seam_face(Job& job, const StoredMesh& mesh, const Tiling& tiling, const Each& each) {
  std::size_t tile = 0;  // of the lowest vertices, which come in order
  SpoolCursor<FaceVertices> faces = mesh.face_cursor(job);
  for (FaceVertices face{}; faces.next(face);) {
    while (face[0] >= tiling.first_vertex(tile + 1)) ++tile;
    const std::uint64_t end = tiling.first_vertex(tile + 1);
    if (face[1] >= end || face[2] >= end) each(face);
  }
}

}  // namespace

IncomingFaces::IncomingFaces(Job& job, const StoredMesh& mesh, const Tiling& tiling,
                             std::uint64_t memory, std::uint64_t hub_faces)
    : faces_(job, share::refine::incoming(memory)), first_(2 * tiling.tiles() + 1, 0) {
  if (tiling.tiles() == 1) {
    faces_.finish();
    return;
  }
  find_hubs(job, mesh, tiling, hub_faces);
  away_.assign(tiling.tiles(), 0);
  SortedRecords<ListedFace> listed(job, share::refine::sorting_incoming(memory));
  for_each_seam_face(job, mesh, tiling, [&](const FaceVertices& face) {
    const std::size_t at_home = home(face, tiling);
    if (const std::size_t lowest = tiling.tile_of(face[0]); at_home != lowest) {
      listed.add({adopted_list(at_home), face});
      ++away_[lowest];
    }
    std::array<std::size_t, 3> told{at_home, at_home, at_home};
    for (std::size_t i = 0; i < 3; ++i) {
      if (is_hub(face[i])) continue;
      const std::size_t tile = tiling.tile_of(face[i]);
      if (std::find(told.begin(), told.end(), tile) == told.end())
        listed.add({incoming_list(tile), face});
      told[i] = tile;
    }
    seam_faces_ += told != std::array{at_home, at_home, at_home};
  });
  MergedCursor<ListedFace> merged = listed.merged();
  Appender<FaceVertices> append(job, faces_);
  for (ListedFace face{}; merged.next(face);) {
    ++first_[face.list + 1];
    append.add(face.vertices);
  }
  append.flush();
  faces_.finish();
  for (std::size_t i = 1; i < first_.size(); ++i) first_[i] += first_[i - 1];
}

// Counts by hashes first, as there may be more vertices than memory has room for: few are worth a
// count of their own.
void IncomingFaces::find_hubs(Job& job, const StoredMesh& mesh, const Tiling& tiling,
                              std::uint64_t hub_faces) {
  constexpr std::uint64_t least_counts = std::uint64_t{1} << 12;
  const std::uint64_t counts = std::bit_ceil(std::max(least_counts, mesh.face_count / hub_faces));
  const Reservation reserved = job.budget.reserve(counts * sizeof(std::uint32_t), "finding hubs");
  std::vector<std::uint32_t> count(counts, 0);
  const auto counted = [&](std::uint32_t v) -> std::uint32_t& {
    return count[mixed_hash(v) & (counts - 1)];
  };
  bool some = false;
  for_each_seam_face(job, mesh, tiling, [&](const FaceVertices& face) {
    for (const std::uint32_t v : face) some |= ++counted(v) > hub_faces;
  });
  if (!some) return;
  std::map<std::uint32_t, std::uint64_t> faces;
  for_each_seam_face(job, mesh, tiling, [&](const FaceVertices& face) {
    for (const std::uint32_t v : face) {
      if (counted(v) > hub_faces) ++faces[v];
    }
  });
  for (const auto& [v, number] : faces) {
    if (number > hub_faces) hubs_.push_back(v);
  }
}

std::size_t IncomingFaces::home(const FaceVertices& face, const Tiling& tiling) const {
  std::uint32_t lowest = UINT32_MAX;
  for (const std::uint32_t v : face) {
    if (!is_hub(v)) lowest = std::min(lowest, v);
  }
  return tiling.tile_of(lowest == UINT32_MAX ? face[0] : lowest);
}

std::vector<FaceVertices> IncomingFaces::read(std::size_t list) const {
  return read_records<FaceVertices>(faces_, first_[list], first_[list + 1] - first_[list]);
}

std::vector<FaceVertices> IncomingFaces::adopted(std::size_t tile) const {
  return read(adopted_list(tile));
}

std::vector<FaceVertices> IncomingFaces::incoming(std::size_t tile) const {
  return read(incoming_list(tile));
}

std::uint64_t Tile::memory(std::uint64_t vertices, std::uint64_t faces, std::size_t state_size) {
  return vertices * (sizeof(IndexedVertex) + state_size) + faces * sizeof(std::uint32_t) +
         TileMesh::memory(vertices, faces);
}

namespace {

// Gives the corners of `faces`, which may be other tiles', their numbers in the tile, and locks
// those of faces that other tiles need.
void lock_shared(Tile& tile, const IncomingFaces& incoming, std::span<const FaceNumber> faces) {
  std::fill(tile.locked.begin() + tile.own_vertices, tile.locked.end(),
            std::uint8_t{closed_vertex});
  for (const FaceNumber f : faces) {
    FaceVertices& face = tile.faces[f];
    std::array<bool, 3> hub{};
    bool shared = false;
    for (std::size_t i = 0; i < 3; ++i) {
      hub[i] = incoming.is_hub(face[i]);
      shared |= !hub[i] && !tile.owns(face[i]);
    }
    for (std::size_t i = 0; i < 3; ++i) {
      std::uint32_t& v = face[i];
      if (tile.owns(v)) {
        v -= static_cast<std::uint32_t>(tile.first_vertex);
      } else {
        const auto other = std::lower_bound(tile.others.begin(), tile.others.end(), v);
        v = static_cast<VertexNumber>(tile.own_vertices + (other - tile.others.begin()));
      }
      if (hub[i]) {
        tile.locked[v] = fixed_hub;
      } else if (shared) {
        tile.locked[v] = closed_vertex;
      }
    }
  }
  for (const std::uint32_t hub : incoming.hubs()) {
    const auto other = std::lower_bound(tile.others.begin(), tile.others.end(), hub);
    if (tile.owns(hub)) tile.hubs.push_back(static_cast<VertexNumber>(hub - tile.first_vertex));
    if (other != tile.others.end() && *other == hub)
      tile.hubs.push_back(
          static_cast<VertexNumber>(tile.own_vertices + (other - tile.others.begin())));
  }
  std::sort(tile.hubs.begin(), tile.hubs.end());
  for (FaceNumber f = 0; f < tile.own_faces; ++f) {
    const auto [a, b, c] = tile.faces[f];
    tile.frozen += (tile.locked[a] == closed_vertex) | (tile.locked[b] == closed_vertex) |
                   (tile.locked[c] == closed_vertex);
  }
}

// By their numbers in the whole mesh.
void load_faces(Tile& tile, const StoredMesh& whole, const Tiling& tiling,
                const IncomingFaces& incoming, std::size_t number) {
  const std::uint64_t first_face = tiling.first_face(number);
  const std::uint64_t end_face = tiling.first_face(number + 1);
  const std::vector<FaceVertices> more = incoming.incoming(number);
  if (incoming.hubs().empty()) {
    tile.faces = whole.read_faces(first_face, end_face - first_face, more.size());
  } else {
    // A hub may have more faces than a tile has room for, most of them in other tiles.
    for (std::uint64_t at = first_face; at < end_face; at += chunk_records) {
      const std::uint64_t count = std::min<std::uint64_t>(chunk_records, end_face - at);
      for (const FaceVertices& face : whole.read_faces(at, count)) {
        if (!incoming.is_hub(face[0]) || incoming.home(face, tiling) == number)
          tile.faces.push_back(face);
      }
    }
    const std::vector<FaceVertices> adopted = incoming.adopted(number);
    tile.faces.insert(tile.faces.end(), adopted.begin(), adopted.end());
  }
  tile.own_faces = static_cast<FaceNumber>(tile.faces.size());
  tile.faces.insert(tile.faces.end(), more.begin(), more.end());
}

void load_positions(Tile& tile, const StoredMesh& whole, bool records) {
  tile.positions.reserve(tile.own_vertices + tile.others.size());
  const auto take = [&](std::span<const IndexedVertex> own) {
    for (const IndexedVertex& vertex : own) tile.positions.push_back(vertex.position);
  };
  const Spool& vertices = whole.vertices->records();
  if (!records && vertices.in_memory()) {
    take(records_in_memory<IndexedVertex>(vertices).subspan(tile.first_vertex, tile.own_vertices));
  } else {
    tile.vertices = read_records<IndexedVertex>(vertices, tile.first_vertex, tile.own_vertices);
    take(tile.vertices);
    if (!records) tile.vertices = {};
  }
  if (tile.others.empty()) return;
  VertexIndex::Reader reader(*whole.vertices);
  for (const std::uint32_t v : tile.others) tile.positions.push_back(reader.position(v));
}

}  // namespace

Tile load_tile(const StoredMesh& whole, const Tiling& tiling, const IncomingFaces& incoming,
               std::size_t number, const TileParts& parts) {
  Tile tile;
  tile.first_vertex = tiling.first_vertex(number);
  tile.own_vertices =
      static_cast<VertexNumber>(tiling.first_vertex(number + 1) - tile.first_vertex);
  load_faces(tile, whole, tiling, incoming, number);

  // Nearly all faces have corners of the tile alone.
  const bool no_hubs = incoming.hubs().empty();
  std::vector<FaceNumber> at_border;
  for (FaceNumber f = 0; f < tile.faces.size(); ++f) {
    FaceVertices& face = tile.faces[f];
    if (no_hubs & tile.owns(face[0]) & tile.owns(face[1]) & tile.owns(face[2])) {
      for (std::uint32_t& v : face) v -= static_cast<std::uint32_t>(tile.first_vertex);
      continue;
    }
    at_border.push_back(f);
    for (const std::uint32_t v : face) {
      if (!tile.owns(v)) tile.others.push_back(v);
    }
  }
  sort_unique(tile.others);
  const std::size_t vertices = tile.own_vertices + tile.others.size();
  tile.locked.assign(vertices, free_vertex);
  if (!at_border.empty() || !no_hubs) lock_shared(tile, incoming, at_border);

  load_positions(tile, whole, parts.records);
  if (whole.state != nullptr) {
    tile.state.resize(vertices * parts.state_size);
    whole.state->read(
        tile.first_vertex * parts.state_size,
        std::span(tile.state).first(std::size_t{tile.own_vertices} * parts.state_size));
  }
  if (parts.attributes > 0) {
    tile.attributes = read_records<double>(*whole.attributes, tile.first_vertex * parts.attributes,
                                           std::uint64_t{tile.own_vertices} * parts.attributes);
  }
  return tile;
}

void load_state_of_others(Tile& tile, const Spool& state, std::size_t state_size) {
  RecentBlocks records(state, state_size);
  std::byte* into = tile.state.data() + std::size_t{tile.own_vertices} * state_size;
  for (const std::uint32_t v : tile.others) {
    const std::span<const std::byte> record = records.record(v);
    std::copy(record.begin(), record.end(), into);
    into += state_size;
  }
}

void lock_beside_hubs(Tile& tile) {
  if (tile.hubs.empty()) return;
  for (const FaceVertices& face : tile.faces) {
    const bool at_hub = std::any_of(face.begin(), face.end(),
                                    [&](VertexNumber v) { return tile.locked[v] == fixed_hub; });
    for (const VertexNumber v : face) {
      if (at_hub && tile.locked[v] == free_vertex) tile.locked[v] = closed_vertex;
    }
  }
}

void take_positions(Tile& tile, std::span<const VertexNumber> moved) {
  std::vector<std::uint8_t> changed(tile.positions.size(), 0);
  std::vector<Point> normals(tile.positions.size(), Point{});
  for (const FaceVertices& face : tile.faces) {
    const bool changes = std::any_of(face.begin(), face.end(), [&](VertexNumber v) {
      return std::binary_search(moved.begin(), moved.end(), v);
    });
    const Point normal =
        doubled_area({tile.positions[face[0]], tile.positions[face[1]], tile.positions[face[2]]});
    for (const VertexNumber v : face) {
      changed[v] |= static_cast<std::uint8_t>(changes);
      normals[v] = normals[v] + normal;
    }
  }
  for (VertexNumber v = 0; v < tile.own_vertices; ++v) {
    tile.vertices[v].position = tile.positions[v];
    if (changed[v] != 0) tile.vertices[v].normal = normal_along(normals[v]);
  }
}

CarriedValues carried_values(Tile& tile, std::span<const Attribute> attributes) {
  if (attributes.empty()) return {};
  std::vector<Point> positions;
  positions.reserve(tile.vertices.size());
  for (const IndexedVertex& vertex : tile.vertices) positions.push_back(vertex.position);
  return {attributes, std::move(positions), std::move(tile.attributes)};
}

}  // namespace winnow
