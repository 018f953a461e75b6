#include "decimate/hyperbolic.hpp"

#include <cmath>
#include <cstddef>

namespace winnow {

namespace {

// Sines of angles. The first by measurement: with a tenth of it a horse of 500 to 3000 faces comes out by a
// good half farther from the original, with two or three times as much no nearer. The rounding of floats
// alone would ask for a thousandth, as it is that part of the edges of a dense scan.
constexpr double behind = 0.1;
constexpr double parallel = 1e-9;

}  // namespace

// If there is such a plane at all then there is one through two of the points: turned until it meets the
// first, then about that until it meets another.
std::optional<Point> supporting_direction(std::span<const Point> seen) {
  for (std::size_t i = 0; i < seen.size(); ++i) {
    for (std::size_t j = i + 1; j < seen.size(); ++j) {
      const Point upright = cross(seen[i], seen[j]);
      const double square = dot(upright, upright);
      if (!(square > parallel * parallel * dot(seen[i], seen[i]) * dot(seen[j], seen[j]))) continue;
      bool some_before = false;
      bool some_behind = false;
      for (std::size_t k = 0; k < seen.size() && !(some_before && some_behind); ++k) {
        if (k == i || k == j) continue;
        const double height = dot(upright, seen[k]);
        if (height * height <= behind * behind * square * dot(seen[k], seen[k])) continue;
        (height > 0 ? some_before : some_behind) = true;
      }
      if (some_before && some_behind) continue;
      return (some_behind ? -1 : 1) / std::sqrt(square) * upright;
    }
  }
  return std::nullopt;
}

}  // namespace winnow
