// What is left of the tiles, joined to one mesh again.
#pragma once

#include "decimate/collapsed_into.hpp"
#include "decimate/decimation.hpp"
#include "io/recent_blocks.hpp"
#include "mesh/vertex_map.hpp"
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

// Where a vertex of a tile went.
struct TileDestination {
  std::uint32_t number = nowhere;  // its place among what is left of the tile
  std::uint32_t is_hub = 0;        // `number` is the old one of another tile's hub
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
  std::vector<TileDestination> destinations;  // of the tile's own vertices, where asked for
};

// Vertices without faces go; the others get the normals of their faces. `into`: null where nobody
// asks where vertices went.
TileResult rest_of(const Tile& tile, const TileMesh& mesh, const Decimation& decimation,
                   const CarriedValues& values, CollapsedInto* into, std::size_t state_size);

// Takes the tiles in order, on one thread.
class RoundOutput {
 public:
  // `map`: whether to tell where vertices went.
  RoundOutput(Job& job, const MeshLayout& layout, bool map, std::uint64_t memory);

  void append(TileResult rest);

  // `tiling`: that of the tiles; `hubs`: IncomingFaces::hubs(). A hub that has lost all its faces
  // is left. The map of the result is of the mesh that was cut into tiles.
  StoredMesh finish(const Tiling& tiling, const std::vector<std::uint32_t>& hubs);

 private:
  void finish_map(const Tiling& tiling, RecentBlocks& named);
  void set_normals(const std::map<std::uint32_t, Point>& normals);
  [[nodiscard]] std::uint32_t new_number(const Tiling& tiling, RecentBlocks& named,
                                         std::uint32_t old_number) const;

  Job& job_;
  std::uint64_t memory_;
  StoredMesh out_;
  Spool faces_, seam_faces_, hub_faces_, named_;
  std::unique_ptr<Spool> destinations_;  // a TileDestination each; null where nobody asks
  std::vector<std::uint64_t> first_vertex_{0}, first_named_{0};
};

}  // namespace winnow
