// How much of the view something takes: the area of its picture on the unit sphere.
#pragma once

#include "base/vector.hpp"

#include <span>

namespace winnow {

// Of a triangle whose corners are seen from the origin, by Van Oosterom and Strackee (1983): between -2 pi
// and 2 pi, positive where the corners turn right round the view of them, as the axes x, y, z do.
double solid_angle(const Point& a, const Point& b, const Point& c);

// Of a fan's faces, seen from its vertex: of the cone that they are the mantle of. `ahead`: no neighbour is
// behind the plane through the vertex that this is upright on.
double solid_angle_of_fan(std::span<const Point> seen, bool closed, const Point& ahead);

}  // namespace winnow
