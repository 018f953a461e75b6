// A clustered mesh in which some cells give way to the parts that they are split into.
#pragma once

#include "cluster/clusterer.hpp"
#include "cluster/split_cells.hpp"
#include "io/job.hpp"

#include <cstddef>

namespace winnow {

// `fine` is of the faces near cells of `split` and has names for keys (cluster/split_cells.hpp). So
// has `coarse`, or keys of cells, which become names when they are shifted by `shift` bits. Folds
// of either are left out. Of `fine` the vertices count that are in cells of `split`, or not in
// `coarse`, and the faces that have one for a corner; of `coarse` all others.
ClusterResult joined(Job& job, const ClusterResult& coarse, unsigned shift,
                     const ClusterResult& fine, const SplitCells& names, const CellSet& split,
                     std::size_t attributes, const MeshMemory& memory);

}  // namespace winnow
