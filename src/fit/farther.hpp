// Whether a face that moved is farther from the original than before, or the original from it.
#pragma once

#include "base/vector.hpp"
#include "decimate/unfold.hpp"

#include <array>
#include <span>

namespace winnow {

// Which corners of a face have moved too far: they bring one of its points farther from the
// reference than it was before, and farther than `far`; or a vertex of the reference that the face
// was nearest to. The points are the corners, the middles of the sides, and the middle. The face
// comes first, then those that touch it, which the vertex may be nearer to.
std::array<bool, 3> farther_corners(ReferenceSurface& reference, std::span<const Triangle> before,
                                    std::span<const Triangle> after, double far);

}  // namespace winnow
