// The distance from a point to a triangle.
#pragma once

#include "base/vector.hpp"

namespace winnow {

// The point of the triangle nearest to `p`, by the region of its plane that `p` stands over
// (Ericson 2005, 5.1.5). Triangles of no area are what they look like: a segment or a point.
Point closest_point(const Point& p, const Triangle& triangle);

// Whether a triangle with these two sides may be a line, but for rounding.
bool may_be_line(const Point& ab, const Point& ac);

}  // namespace winnow
