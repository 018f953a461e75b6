#include "fit/farther.hpp"

#include "base/closest_point.hpp"

#include <algorithm>
#include <cstddef>
#include <limits>
#include <vector>

namespace winnow {

namespace {

// Weights of the corners.
constexpr std::array<std::array<double, 3>, 7> points{{{1, 0, 0},
                                                       {0, 1, 0},
                                                       {0, 0, 1},
                                                       {0.5, 0.5, 0},
                                                       {0, 0.5, 0.5},
                                                       {0.5, 0, 0.5},
                                                       {1.0 / 3, 1.0 / 3, 1.0 / 3}}};

// So many times the limit around a face the reference is known; a distance above tells nothing.
constexpr double known = 1.5;

Point point_at(const Triangle& t, const std::array<double, 3>& weight) {
  return weight[0] * t[0] + (weight[1] * t[1] + weight[2] * t[2]);
}

// Of the distance, squared, no more than whether it is `enough` or less.
double squared_distance(const Point& point, const std::vector<Triangle>& faces, double enough) {
  double least = std::numeric_limits<double>::infinity();
  for (const Triangle& face : faces) {
    const Point off = point - closest_point(point, face);
    least = std::min(least, dot(off, off));
    if (least <= enough) break;
  }
  return least;
}

}  // namespace

std::array<bool, 3> farther_corners(ReferenceSurface& reference, const Triangle& before,
                                    const Triangle& after, double far) {
  Box around;
  for (std::size_t i = 0; i < 3; ++i) {
    around.add(before[i]);
    around.add(after[i]);
  }
  for (std::size_t axis = 0; axis < 3; ++axis) {
    around.low[axis] -= known * far;
    around.high[axis] += known * far;
  }
  const std::vector<Triangle> faces = reference.faces_near(around);
  std::array<bool, 3> corners{};
  for (const auto& weight : points) {
    const double now = squared_distance(point_at(after, weight), faces, far * far);
    if (now <= far * far) continue;
    const double then = squared_distance(point_at(before, weight), faces, 0);
    if (now < then && then <= known * known * far * far) continue;
    for (std::size_t i = 0; i < 3; ++i) corners[i] |= weight[i] > 0;
  }
  return corners;
}

}  // namespace winnow
