// Parts of cells that are too small for two vertices of the input hold one as it was.
#pragma once

#include "cluster/clusterer.hpp"
#include "cluster/near_faces.hpp"
#include "cluster/split_cells.hpp"
#include "io/job.hpp"

#include <cstdint>

namespace winnow {

// Puts the vertices of `mesh` that are of the finest parts where the input has them: `near` are the
// faces that the mesh was made of. False, and nothing done, where one of these parts holds several
// positions. `single`: positions are rounded to floats. Sorts within `memory`; `vertices`: of the
// mesh.
bool place_exactly(Job& job, const NearFaces& near, const SplitCells& names, bool single,
                   std::uint64_t memory, std::uint64_t vertices, StoredMesh& mesh);

}  // namespace winnow
