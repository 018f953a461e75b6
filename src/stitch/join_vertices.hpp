// Meets a count where no edge is left that could be collapsed, as where all vertices are hubs:
// vertices that are near each other become one.
#pragma once

#include "io/job.hpp"
#include "mesh/stored_mesh.hpp"

#include <cstdint>

namespace winnow {

// Cells of the order in which the vertices are, each half of one twice as large, become one vertex,
// from the smallest cells on and in their order, until no more than `faces` are left. The vertex in
// the middle of a cell's own stays. Of faces with the same three corners one stays. False, and
// nothing done, where no face would be left or the budget has no room. Sorts within `lists`;
// `memory`: for what comes out.
bool join_vertices(Job& job, StoredMesh& whole, std::uint64_t faces, std::uint64_t lists,
                   std::uint64_t memory);

}  // namespace winnow
