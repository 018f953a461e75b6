// Where floats are too coarse for a mesh.
#pragma once

#include "base/box.hpp"
#include "io/job.hpp"

#include <cstdint>

namespace winnow {

// Says so where positions are going to be rounded to floats, and those step by more than a sixteenth of what
// an edge is about as long as.
void note_coarse_floats(Job& job, const Box& box, std::uint64_t faces);

}  // namespace winnow
