// What is left of the tiles, joined to one mesh again.
#pragma once

#include "decimate/decimation.hpp"
#include "io/recent_blocks.hpp"
#include "stitch/tile.hpp"

#include <array>
#include <cstdint>
#include <map>
#include <memory>
#include <vector>

namespace winnow {

// A face with corners in several tiles, on its way to its new numbers.
struct SeamFace {
  FaceVertices vertices;
  std::uint32_t old_mask;  // bit i: corner i is another tile's and still has its old number
};

// A vertex that other tiles' faces name.
struct NamedVertex {
  std::uint32_t old_number;
  std::uint32_t place;  // among what is left of its tile
};

// A vertex's normal from the sum of its faces' normals; zeros if that is zero.
std::array<float, 3> normal_along(const Point& sum);

// What is left of one tile.
struct TileResult {
  std::vector<IndexedVertex> vertices;
  std::vector<std::byte> state;
  std::vector<double> attributes;
  std::vector<FaceVertices> faces;  // by places in `vertices`, the lowest first; in ascending order
  std::vector<SeamFace>
      seam_faces;                   // the lowest first, which is the tile's own; in ascending order
  std::vector<SeamFace> hub_faces;  // those that have a hub; in any order
  std::vector<NamedVertex> named;   // in ascending order
  TopologyChanges changes;          // that its collapses made
};

// Vertices without faces go; the others get the normals of their faces.
TileResult rest_of(const Tile& tile, const TileMesh& mesh, const Decimation& decimation,
                   const CarriedValues& values, std::size_t state_size);

// Takes the tiles in order, on one thread.
class RoundOutput {
 public:
  RoundOutput(Job& job, const MeshLayout& layout, std::uint64_t memory);

  void append(TileResult rest);

  // `tiling`: that of the tiles; `hubs`: IncomingFaces::hubs(). A hub that has lost all its faces
  // is left.
  StoredMesh finish(const Tiling& tiling, const std::vector<std::uint32_t>& hubs);

 private:
  void set_normals(const std::map<std::uint32_t, Point>& normals);
  [[nodiscard]] std::uint32_t new_number(const Tiling& tiling, RecentBlocks& named,
                                         std::uint32_t old_number) const;

  Job& job_;
  std::uint64_t memory_;
  StoredMesh out_;
  Spool faces_, seam_faces_, hub_faces_, named_;
  std::vector<std::uint64_t> first_vertex_{0}, first_named_{0};
};

}  // namespace winnow
