// Whether faces that moved are farther from the original than before.
#pragma once

#include "base/vector.hpp"
#include "decimate/unfold.hpp"

#include <array>

namespace winnow {

// Which corners of a face bring one of its points farther from the reference than it was before,
// and farther than `far`: the corners, the middles of the sides, and the middle.
std::array<bool, 3> farther_corners(ReferenceSurface& reference, const Triangle& before,
                                    const Triangle& after, double far);

}  // namespace winnow
