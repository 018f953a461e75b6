// One tile in memory: its own vertices, all faces that touch one, and the other corners of those.
#pragma once

#include "cluster/clusterer.hpp"
#include "decimate/carried_values.hpp"
#include "decimate/tile_mesh.hpp"
#include "stitch/tiling.hpp"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace winnow {

// A mesh between two rounds: clustered or welded, then smaller and smaller.
struct RefinedMesh {
  ClusteredMesh mesh;
  std::unique_ptr<Spool> state;  // Decimation::state_size() bytes a vertex; none where nothing was collapsed
};

// Faces that have a corner in a tile behind that of their lowest vertex, for each such tile.
class IncomingFaces {
 public:
  IncomingFaces(Job& job, const ClusteredMesh& mesh, const Tiling& tiling, std::uint64_t memory);

  [[nodiscard]] std::uint64_t count(std::size_t tile) const { return first_[tile + 1] - first_[tile]; }
  [[nodiscard]] std::vector<FaceVertices> faces(std::size_t tile) const;

  // Faces with corners in several tiles.
  [[nodiscard]] std::uint64_t seam_faces() const { return seam_faces_; }

 private:
  Spool faces_;
  std::vector<std::uint64_t> first_;
  std::uint64_t seam_faces_ = 0;
};

// Numbers in a tile: first its own vertices, in order, then the others.
struct Tile {
  std::uint64_t first_vertex = 0;  // number in the whole mesh of the tile's first
  VertexNumber own_vertices = 0;
  FaceNumber own_faces = 0;             // those whose lowest vertex is the tile's own come first
  std::vector<std::uint32_t> others;    // numbers in the whole mesh
  std::vector<IndexedVertex> vertices;  // the tile's own
  std::vector<Point> positions;
  std::vector<FaceVertices> faces;
  std::vector<std::uint8_t> locked;  // corners of faces with corners in several tiles
  std::vector<std::byte> state;      // of all vertices (zero for the others), or empty
  std::vector<double> attributes;    // of the tile's own vertices, so many each

  // Bytes in use at the most while it is loaded, collapsed and given away.
  static std::uint64_t memory(std::uint64_t vertices, std::uint64_t faces, std::size_t state_size);
};

Tile load_tile(const RefinedMesh& whole, const Tiling& tiling, const IncomingFaces& incoming,
               std::size_t number, std::size_t state_size, std::size_t attributes);

// What the tile's own vertices carry.
CarriedValues carried_values(Tile& tile, std::size_t attributes);

}  // namespace winnow
