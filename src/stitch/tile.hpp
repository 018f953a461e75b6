// One tile in memory: its own vertices, all faces that touch one, and the other corners of those.
#pragma once

#include "decimate/carried_values.hpp"
#include "decimate/tile_mesh.hpp"
#include "mesh/stored_mesh.hpp"
#include "stitch/tiling.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace winnow {

// Which faces a tile has beside those whose lowest vertex is its own.
//
// A face belongs to the tile of its lowest vertex, and comes to each other tile that has a corner
// of it. Not so for a hub, a vertex with very many faces that have corners in several tiles: all of
// them would be locked, and its tile would be as large as they are many. A hub stays as it is in
// every tile, no tile gets a face because of it, and a face that has one belongs to the tile of its
// lowest corner that is none.
class IncomingFaces {
 public:
  // `hub_faces`: a vertex with more faces across tiles is a hub.
  IncomingFaces(Job& job, const StoredMesh& mesh, const Tiling& tiling, std::uint64_t memory,
                std::uint64_t hub_faces);

  // The tile's own, of hubs in other tiles.
  [[nodiscard]] std::vector<FaceVertices> adopted(std::size_t tile) const;
  // Those of other tiles.
  [[nodiscard]] std::vector<FaceVertices> incoming(std::size_t tile) const;
  [[nodiscard]] std::uint64_t count(std::size_t tile) const {
    return first_[2 * tile + 2] - first_[2 * tile];
  }

  // How many of the faces whose lowest vertex is the tile's belong to other tiles.
  [[nodiscard]] std::uint64_t away(std::size_t tile) const {
    return away_.empty() ? 0 : away_[tile];
  }

  // Vertices that are hubs, in ascending order.
  [[nodiscard]] const std::vector<std::uint32_t>& hubs() const { return hubs_; }
  [[nodiscard]] bool is_hub(std::uint32_t vertex) const {
    return !hubs_.empty() && std::binary_search(hubs_.begin(), hubs_.end(), vertex);
  }
  // The tile that the face belongs to.
  [[nodiscard]] std::size_t home(const FaceVertices& face, const Tiling& tiling) const;

  // Faces that several tiles need.
  [[nodiscard]] std::uint64_t seam_faces() const { return seam_faces_; }

 private:
  void find_hubs(Job& job, const StoredMesh& mesh, const Tiling& tiling, std::uint64_t hub_faces);
  [[nodiscard]] std::vector<FaceVertices> read(std::size_t list) const;

  Spool faces_;
  std::vector<std::uint64_t> first_;  // of each tile the adopted ones, then the incoming
  std::vector<std::uint32_t> hubs_;
  std::vector<std::uint64_t> away_;
  std::uint64_t seam_faces_ = 0;
};

// Numbers in a tile: first its own vertices, in order, then the others.
struct Tile {
  std::uint64_t first_vertex = 0;  // number in the whole mesh of the tile's first
  VertexNumber own_vertices = 0;
  FaceNumber own_faces = 0;             // those that belong to the tile come first
  std::uint64_t frozen = 0;             // of them, that the tile's borders keep as they are
  std::vector<std::uint32_t> others;    // numbers in the whole mesh
  std::vector<IndexedVertex> vertices;  // the tile's own, where asked for
  std::vector<Point> positions;
  std::vector<FaceVertices> faces;
  std::vector<std::uint8_t> locked;  // corners of faces with corners in several tiles, and hubs
  std::vector<VertexNumber> hubs;    // in ascending order
  std::vector<std::byte> state;      // of all vertices (zero for the others), or empty
  std::vector<double> attributes;    // of the tile's own vertices, so many each

  // By its number in the whole mesh.
  [[nodiscard]] bool owns(std::uint32_t vertex) const {
    return vertex - static_cast<std::uint32_t>(first_vertex) < own_vertices;
  }

  // Bytes in use at the most while it is loaded, collapsed and given away.
  static std::uint64_t memory(std::uint64_t vertices, std::uint64_t faces, std::size_t state_size);
};

// The most that memory_of(vertices, faces) says of any tile.
template <typename MemoryOf>
std::uint64_t largest_tile(const Tiling& tiling, const IncomingFaces& incoming,
                           const MemoryOf& memory_of) {
  std::uint64_t largest = 0;
  for (std::size_t t = 0; t < tiling.tiles(); ++t) {
    const std::uint64_t faces =
        tiling.first_face(t + 1) - tiling.first_face(t) - incoming.away(t) + incoming.count(t);
    // An incoming face brings at most two vertices along, an own one too few to count.
    const std::uint64_t vertices =
        tiling.first_vertex(t + 1) - tiling.first_vertex(t) + 2 * incoming.count(t);
    largest = std::max(largest, memory_of(vertices, faces));
  }
  return largest;
}

// What of a tile is loaded beside its faces and positions.
struct TileParts {
  bool records = true;  // of its own vertices
  std::size_t state_size = 0;
  std::size_t attributes = 0;  // numbers a vertex
};

Tile load_tile(const StoredMesh& whole, const Tiling& tiling, const IncomingFaces& incoming,
               std::size_t number, const TileParts& parts);

// In place of zeros: the positions of other tiles' vertices in later frames are a part of theirs.
void load_state_of_others(Tile& tile, const Spool& state, std::size_t state_size);

// A tile does not know all faces of a hub. Where vertices move, its normal has to stay, and so have
// the vertices beside it.
void lock_beside_hubs(Tile& tile);

// When `positions` of these have changed: gives the tile's own vertices theirs, and those of
// changed faces new normals. `moved`: ascending.
void take_positions(Tile& tile, std::span<const VertexNumber> moved);

// What the tile's own vertices carry.
CarriedValues carried_values(Tile& tile, std::span<const Attribute> attributes);

}  // namespace winnow
