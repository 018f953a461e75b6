#include "decimate/solid_angle.hpp"

#include "base/trigonometry.hpp"
#include "decimate/fan.hpp"

#include <cmath>

namespace winnow {

double solid_angle(const Point& a, const Point& b, const Point& c) {
  const double along_a = length(a);
  const double along_b = length(b);
  const double along_c = length(c);
  return 2 * angle_of(dot(a, cross(b, c)), along_a * along_b * along_c + dot(a, b) * along_c +
                                               dot(a, c) * along_b + dot(b, c) * along_a);
}

double solid_angle_of_fan(std::span<const Point> seen, bool closed, const Point& ahead) {
  // Guha, definition 2, triangulates the fan's picture on a plane before the vertex. Triangles that
  // have a point of the view in common do the same without the plane: those outside of the picture cancel
  // out. With `ahead` for the point no two corners are ever opposite, also where the vertex is on the hull of
  // its neighbours. So the definition's own case for that is not needed: a flat vertex comes to 2 pi by
  // itself, and one on a straight crease, which the definition would call as blunt as a flat one, to the
  // angle of the crease.
  double sum = 0;
  for (std::size_t i = 0; i < faces_of_fan(seen.size(), closed); ++i)
    sum += solid_angle(ahead, seen[i], seen[next_in_fan(i, seen.size())]);
  return std::abs(sum);
}

}  // namespace winnow
