// The plane that is nearest to some points.
#pragma once

#include "base/vector.hpp"

#include <cmath>
#include <span>

namespace winnow {

struct Plane {
  Point through{};
  Point normal{};  // of length 1

  [[nodiscard]] double distance(const Point& p) const { return std::abs(dot(normal, p - through)); }
};

// With the least sum of squared distances. Of points that several planes fit equally well, one of those.
Plane best_fit_plane(std::span<const Point> points);

}  // namespace winnow
