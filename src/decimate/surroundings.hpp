// How a face lies beside the reference near it.
#pragma once

#include "base/box.hpp"
#include "base/rounding.hpp"
#include "decimate/surface_patch.hpp"
#include "decimate/unfold.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>

namespace winnow {

// How much a corner weighs in the inner point nearest to it, and the other two.
inline constexpr double near_corner_weight = 0.6;
inline constexpr double far_corner_weight = 0.2;

inline Point middle_of(const Triangle& t) {
  return 1.0 / 3 * (t[0] + t[1] + t[2]);
}

// The middle, and a point near each corner.
inline std::array<Point, 4> inner_points(const Triangle& t) {
  const Point sum = far_corner_weight * (t[0] + t[1] + t[2]);
  const auto near = [&](const Point& corner) {
    return sum + (near_corner_weight - far_corner_weight) * corner;
  };
  return {middle_of(t), near(t[0]), near(t[1]), near(t[2])};
}

inline double weight_of(std::size_t corner, std::size_t inner_point) {
  if (inner_point == 0) return 1.0 / 3;
  return inner_point == corner + 1 ? near_corner_weight : far_corner_weight;
}

// Its height is next to nothing beside its longest side.
inline bool is_line(const Triangle& t, const CoordinateRounding& rounding) {
  constexpr double thinnest = 1e-10;
  const Point normal = doubled_area(t);
  double longest = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    const Point side = t[(i + 1) % 3] - t[i];
    longest = std::max(longest, dot(side, side));
  }
  return !(length(normal) > thinnest * longest) || thinner_than_rounding(t, normal, rounding);
}

inline Box box_around(const Triangle& t) {
  Box box;
  for (const Point& corner : t) box.add(corner);
  return box;
}

inline Box enlarged(Box box, double margin) {
  const Point more{margin, margin, margin};
  box.low = box.low - more;
  box.high = box.high + more;
  return box;
}

// Faces of the reference near each inner point of a face.
using Hints = std::array<SurfacePatch::Hint, 4>;
inline constexpr Hints no_hints{SurfacePatch::unknown, SurfacePatch::unknown, SurfacePatch::unknown,
                                SurfacePatch::unknown};

// The reference in a box and a margin around it.
class Surroundings {
 public:
  Surroundings(ReferenceSurface& reference, const Box& box, double margin)
      : patch_(reference.faces_near(enlarged(box, margin))), most_squared_(margin * margin) {}

  // Nothing if the nearest face is beyond the margin: others, which are not known, may be nearer.
  std::optional<double> squared_distance(const Point& point, SurfacePatch::Hint& hint) const {
    const double squared = patch_.squared_distance(point, hint);
    return squared <= most_squared_ ? std::optional(squared) : std::nullopt;
  }

  [[nodiscard]] const SurfacePatch& patch() const { return patch_; }

  bool flipped(const Triangle& t, Hints& hints) const {
    const Point normal = doubled_area(t);
    const std::array<Point, 4> points = inner_points(t);
    for (std::size_t i = 0; i < points.size(); ++i) {
      if (!patch_.opposed(points[i], normal, hints[i])) return false;
    }
    return true;
  }

  // The squared distance times the area; nothing as for a point.
  std::optional<double> error(const Triangle& t, Hints& hints) const {
    const std::array<Point, 4> points = inner_points(t);
    double sum = 0;
    for (std::size_t i = 0; i < points.size(); ++i) {
      const auto squared = squared_distance(points[i], hints[i]);
      if (!squared) return {};
      sum += *squared;
    }
    return sum / 4 * length(doubled_area(t)) / 2;
  }

 private:
  SurfacePatch patch_;
  double most_squared_;
};

}  // namespace winnow
