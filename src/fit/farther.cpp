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

double squared_distance(const Point& point, const Triangle& face) {
  const Point off = point - closest_point(point, face);
  return dot(off, off);
}

// Of the distance, squared, no more than whether it is `enough` or less.
double squared_distance(const Point& point, std::span<const Triangle> faces, double enough) {
  double least = std::numeric_limits<double>::infinity();
  for (const Triangle& face : faces) {
    least = std::min(least, squared_distance(point, face));
    if (least <= enough) break;
  }
  return least;
}

bool is_in(const Point& point, const Box& box) {
  bool in = true;
  for (std::size_t axis = 0; axis < 3; ++axis)
    in &= point[axis] >= box.low[axis] && point[axis] <= box.high[axis];
  return in;
}

}  // namespace

std::array<bool, 3> farther_corners(ReferenceSurface& reference, std::span<const Triangle> before,
                                    std::span<const Triangle> after, double far) {
  Box around;
  for (std::size_t i = 0; i < 3; ++i) {
    around.add(before[0][i]);
    around.add(after[0][i]);
  }
  for (std::size_t axis = 0; axis < 3; ++axis) {
    around.low[axis] -= known * far;
    around.high[axis] += known * far;
  }
  const std::vector<Triangle> faces = reference.faces_near(around);
  const double allowed = far * far;
  const double seen = known * known * allowed;
  std::array<bool, 3> corners{};
  for (const auto& weight : points) {
    const double now = squared_distance(point_at(after[0], weight), faces, allowed);
    if (now <= allowed) continue;
    const double then = squared_distance(point_at(before[0], weight), faces, 0);
    if (now < then && then <= seen) continue;
    for (std::size_t i = 0; i < 3; ++i) corners[i] |= weight[i] > 0;
  }
  // Whether a vertex was nearest to the face, and is now farther from all of them.
  const auto left_behind = [&](const Point& vertex) {
    if (!is_in(vertex, around) || squared_distance(vertex, after[0]) <= allowed) return false;
    const double then = squared_distance(vertex, before[0]);
    if (then > seen || squared_distance(vertex, before.subspan(1), 0) < then) return false;
    return squared_distance(vertex, after, std::max(then, allowed)) > std::max(then, allowed);
  };
  for (const Triangle& face : faces) {
    if (std::any_of(face.begin(), face.end(), left_behind)) return {true, true, true};
  }
  return corners;
}

}  // namespace winnow
