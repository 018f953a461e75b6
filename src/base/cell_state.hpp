// What a clustered vertex knows of the surface that it stands for.
#pragma once

#include "base/quadric.hpp"

#include <array>
#include <cmath>
#include <limits>

namespace winnow {

// The float beyond `x` in a direction, 1 or -1; 0 stays.
inline float outwards(double x, int direction) {
  const float end = static_cast<float>(direction) * std::numeric_limits<float>::max();
  return x == 0 ? 0 : std::nextafter(static_cast<float>(x), end);
}

// Both seen from the vertex.
struct CellState {
  Quadric planes;
  // The box that all of it is in, rounded outwards.
  std::array<float, 3> low{}, high{};
};

}  // namespace winnow
