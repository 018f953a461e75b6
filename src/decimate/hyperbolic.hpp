// Vertices that their neighbours enclose.
#pragma once

#include "base/vector.hpp"

#include <optional>
#include <span>

namespace winnow {

// A plane through the origin has none of these points behind it: the direction upright on it, of length 1.
// Nothing where every plane has some: then a vertex there is hyperbolic (Guha, definition 1), strictly
// inside the convex hull of its neighbours.
//
// A point counts as behind a plane if it is so by more than a small angle. Taken to the letter, noise and
// rounding make every other vertex of a part that is all but flat hyperbolic, and those stay for good.
std::optional<Point> supporting_direction(std::span<const Point> seen);

}  // namespace winnow
