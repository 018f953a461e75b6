// Where floats, or whole numbers, are too coarse for a mesh.
#pragma once

#include "base/box.hpp"
#include "io/job.hpp"

#include <cstdint>

namespace winnow {

// Says so where positions are going to be rounded to floats, and those step by more than a
// sixteenth of what an edge is about as long as.
void note_coarse_floats(Job& job, const Box& box, std::uint64_t faces);

// Likewise where `error`, by which positions move at most, is more than a quarter of such an edge.
void note_coarse_steps(Job& job, const Box& box, std::uint64_t faces, double error);

// Throws Error(usage) where floats do not reach.
void check_floats(const Box& box);

}  // namespace winnow
