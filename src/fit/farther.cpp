#include "fit/farther.hpp"

#include "base/closest_point.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <iterator>
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

// Whether the point is within `far` of a face. Most faces are told to be farther by their boxes.
bool is_within(const Point& point, std::span<const Triangle> faces, double far) {
  return std::any_of(faces.begin(), faces.end(), [&](const Triangle& face) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const auto [low, high] = std::minmax({face[0][axis], face[1][axis], face[2][axis]});
      if (point[axis] < low - far || point[axis] > high + far) return false;
    }
    return squared_distance(point, face) <= far * far;
  });
}

// Tells fast of most points beside a face on which side of a distance they are.
class FastDistance {
 public:
  explicit FastDistance(const Triangle& face) : corner_(face) {
    if (may_be_line(face[1] - face[0], face[2] - face[0])) return;
    up_ = unit(doubled_area(face));
    for (std::size_t i = 0; i < 3; ++i) out_[i] = unit(cross(face[(i + 1) % 3] - face[i], up_));
    known_ = true;
  }
  // Only over the inside of the face.
  [[nodiscard]] bool is_surely_within(const Point& point, double far) const {
    return known_ && height(point) <= almost * far && farthest_out(point) <= 0;
  }
  [[nodiscard]] bool is_surely_beyond(const Point& point, double far) const {
    return known_ && std::max(height(point), farthest_out(point)) * almost > far;
  }

 private:
  static constexpr double almost = 0.99;  // what rounding may be

  [[nodiscard]] double height(const Point& point) const {
    return std::abs(dot(point - corner_[0], up_));
  }
  // The distance from the sides' planes, where the point is on their outer side.
  [[nodiscard]] double farthest_out(const Point& point) const {
    const double first = dot(point - corner_[0], out_[0]);
    const double second = dot(point - corner_[1], out_[1]);
    const double third = dot(point - corner_[2], out_[2]);
    return std::max(first, std::max(second, third));
  }

  Triangle corner_;
  Point up_{};
  std::array<Point, 3> out_{};
  bool known_ = false;
};

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
    const Point point = point_at(after[0], weight);
    if (is_within(point, faces, far)) continue;
    const double now = squared_distance(point, faces, 0);
    const double then = squared_distance(point_at(before[0], weight), faces, 0);
    if (now < then && then <= seen) continue;
    for (std::size_t i = 0; i < 3; ++i) corners[i] |= weight[i] > 0;
  }
  // Whether a vertex was nearest to the face, and is now farther from all of them.
  const auto left_behind = [&](const Point& vertex) {
    if (squared_distance(vertex, after[0]) <= allowed) return false;
    const double then = squared_distance(vertex, before[0]);
    if (then > seen) return false;
    const double nearer = std::nextafter(then, 0);
    if (squared_distance(vertex, before.subspan(1), nearer) <= nearer) return false;
    return squared_distance(vertex, after, std::max(then, allowed)) > std::max(then, allowed);
  };
  const FastDistance from(before[0]);
  const FastDistance to(after[0]);
  std::vector<Point> beside;
  for (const Triangle& face : faces) {
    std::copy_if(face.begin(), face.end(), std::back_inserter(beside), [&](const Point& vertex) {
      return is_in(vertex, around) && !from.is_surely_beyond(vertex, known * far) &&
             !to.is_surely_within(vertex, far);
    });
  }
  // A vertex comes with each of its faces.
  std::sort(beside.begin(), beside.end());
  beside.erase(std::unique(beside.begin(), beside.end()), beside.end());
  if (std::any_of(beside.begin(), beside.end(), left_behind)) return {true, true, true};
  return corners;
}

}  // namespace winnow
