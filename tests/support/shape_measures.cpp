#include "support/shape_measures.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace winnow::test {

namespace {

using Corners = std::array<std::uint32_t, 3>;
using Side = std::array<std::uint32_t, 2>;

Triangle triangle_of(const Shape& shape, const Corners& face) {
  return {shape.vertices[face[0]], shape.vertices[face[1]], shape.vertices[face[2]]};
}

double distance(const Point& p, const Segment& to) {
  const Point along = to[1] - to[0];
  const double squared = dot(along, along);
  const double at = squared > 0 ? std::clamp(dot(p - to[0], along) / squared, 0.0, 1.0) : 0;
  return length(p - (to[0] + at * along));
}

}  // namespace

double area(const Shape& shape) {
  double sum = 0;
  for (const Corners& face : shape.faces) sum += length(doubled_area(triangle_of(shape, face))) / 2;
  return sum;
}

std::optional<double> volume(const Shape& shape) {
  std::vector<Side> sides;
  std::vector<Side> opposite;
  double sum = 0;
  for (const Corners& face : shape.faces) {
    for (std::size_t i = 0; i < 3; ++i) {
      sides.push_back({face[i], face[(i + 1) % 3]});
      opposite.push_back({face[(i + 1) % 3], face[i]});
    }
    const Triangle t = triangle_of(shape, face);
    sum += dot(t[0] - shape.vertices[0], doubled_area(t)) / 6;
  }
  std::sort(sides.begin(), sides.end());
  std::sort(opposite.begin(), opposite.end());
  if (sides != opposite) return {};
  return sum;
}

Box box_of(const Shape& shape) {
  Box box;
  for (const Point& p : shape.vertices) box.add(p);
  return box;
}

std::size_t faces_without_area(const Shape& shape) {
  return static_cast<std::size_t>(std::count_if(
      shape.faces.begin(), shape.faces.end(),
      [&](const Corners& face) { return !(length(doubled_area(triangle_of(shape, face))) > 0); }));
}

std::size_t faces_near(const Shape& shape, const Point& middle, double radius) {
  return static_cast<std::size_t>(
      std::count_if(shape.faces.begin(), shape.faces.end(), [&](const Corners& face) {
        const Triangle corners = triangle_of(shape, face);
        return std::all_of(corners.begin(), corners.end(),
                           [&](const Point& p) { return length(p - middle) <= radius; });
      }));
}

std::vector<Segment> border_of(const Shape& shape) {
  std::vector<Side> sides;
  for (const Corners& face : shape.faces) {
    for (std::size_t i = 0; i < 3; ++i) {
      const auto [low, high] = std::minmax(face[i], face[(i + 1) % 3]);
      sides.push_back({low, high});
    }
  }
  std::sort(sides.begin(), sides.end());
  std::vector<Segment> border;
  for (std::size_t i = 0; i < sides.size();) {
    std::size_t end = i;
    while (end < sides.size() && sides[end] == sides[i]) ++end;
    if (end - i == 1) border.push_back({shape.vertices[sides[i][0]], shape.vertices[sides[i][1]]});
    i = end;
  }
  return border;
}

double border_distance(const std::vector<Segment>& from, const std::vector<Segment>& to,
                       std::size_t inner) {
  double largest = 0;
  for (const Segment& edge : from) {
    for (std::size_t i = 0; i <= inner; ++i) {
      const Point p =
          edge[0] + (static_cast<double>(i) / static_cast<double>(inner + 1)) * (edge[1] - edge[0]);
      double nearest = std::numeric_limits<double>::infinity();
      for (const Segment& other : to) nearest = std::min(nearest, distance(p, other));
      largest = std::max(largest, nearest);
    }
  }
  return largest;
}

}  // namespace winnow::test
