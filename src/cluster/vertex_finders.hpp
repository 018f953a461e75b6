// Which vertex of a welded or clustered mesh a position of the input became.
#pragma once

#include "cluster/grid.hpp"
#include "cluster/map_of_input.hpp"
#include "cluster/split_cells.hpp"
#include "mesh/stored_mesh.hpp"

namespace winnow {

// What the finders look in must stay.

// `lattice`: that of the vertices' keys.
MakeFinder welded_finder(const StoredMesh& mesh, const Grid& lattice);

// `split`: null where no cell was. Keys of vertices are names without so many of the lowest bits.
MakeFinder clustered_finder(const StoredMesh& mesh, const Grid& grid, const SplitCells* split,
                            unsigned shift);

}  // namespace winnow
