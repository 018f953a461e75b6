// What the rounding of positions leaves unknown.
#pragma once

#include "base/vector.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace winnow {

// By how much a coordinate may be off, beside its size, and twice that for what was turned or moved
// before it was rounded.
inline constexpr double rounding_of_float = 0x1p-23;
inline constexpr double rounding_of_double = 0x1p-51;

// How far a coordinate may be off: so much of its size, and so much whatever its size.
struct CoordinateRounding {
  double relative;
  double absolute;

  CoordinateRounding(double of_its_size = rounding_of_double, double of_any = 0)
      : relative(of_its_size), absolute(of_any) {}
  bool operator==(const CoordinateRounding&) const = default;
};

inline CoordinateRounding coordinate_rounding(bool single) {
  return {single ? rounding_of_float : rounding_of_double, 0};
}

// Whether a face is no higher than its corners' coordinates may be off: its normal is made of
// rounding. For each axis by itself: a place far off in the plane says nothing of heights.
// `doubled`: doubled_area().
inline bool thinner_than_rounding(const Triangle& t, const Point& doubled,
                                  const CoordinateRounding& rounding) {
  Point off;
  Point extent;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const double others = std::max(std::abs(t[1][axis]), std::abs(t[2][axis]));
    off[axis] = rounding.relative * std::max(others, std::abs(t[0][axis])) + rounding.absolute;
    extent[axis] = std::abs(t[1][axis] - t[0][axis]) + std::abs(t[2][axis] - t[0][axis]);
  }
  return std::abs(doubled[0]) <= extent[1] * off[2] + extent[2] * off[1] &&
         std::abs(doubled[1]) <= extent[2] * off[0] + extent[0] * off[2] &&
         std::abs(doubled[2]) <= extent[0] * off[1] + extent[1] * off[0];
}

}  // namespace winnow
