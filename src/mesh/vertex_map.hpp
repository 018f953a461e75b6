// Where vertices went: of each vertex of the input, or of a mesh, the number of its vertex in a
// later mesh.
#pragma once

#include "io/job.hpp"
#include "io/spool.hpp"

#include <cstdint>
#include <memory>

namespace winnow {

// Spools of these have one number for each vertex, in the order of vertices.
using Destination = std::uint32_t;
inline constexpr Destination nowhere = UINT32_MAX;  // the vertex is in no mesh any more

// Where the vertices went that `first` leads to vertices of which `then` tells where they went.
// Keeps at most `memory` bytes of it in memory.
std::unique_ptr<Spool> composed(Job& job, const Spool& first, const Spool& then,
                                std::uint64_t memory);

}  // namespace winnow
