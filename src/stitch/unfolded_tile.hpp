// One tile in the last step of refinement: flipped faces are turned over.
#pragma once

#include "mesh/vertex_index.hpp"
#include "stitch/reference_mesh.hpp"
#include "stitch/tile.hpp"

#include <cstdint>
#include <vector>

namespace winnow {

// The tile's own vertices, some of them moved (decimate/unfold.hpp). Vertices that several tiles
// need stay. `reference_faces`: how many there are for each face of the mesh.
std::vector<IndexedVertex> unfolded_vertices(Tile tile, const ReferenceMesh& reference,
                                             std::uint64_t reference_faces,
                                             const UnfoldRules& rules);

// What a tile of so many vertices and faces takes meanwhile.
std::uint64_t unfolded_tile_memory(std::uint64_t vertices, std::uint64_t faces);

}  // namespace winnow
