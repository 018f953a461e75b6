// Points spread evenly over a surface, the same whatever the order in which its faces come.
#pragma once

#include "base/hash.hpp"
#include "base/vector.hpp"

#include <cmath>
#include <cstdint>

namespace winnow {

// Every face gets its area times `density` points, the fraction by a chance that hangs on its
// number, as do the places of the points.
class SurfaceSampler {
 public:
  explicit SurfaceSampler(double density) : density_(density) {}

  [[nodiscard]] std::uint64_t count(std::uint64_t number, double area) const {
    const double wanted = area * density_;
    if (!(wanted < 1e15)) return 0;
    return static_cast<std::uint64_t>(wanted + chance(mixed_hash(number)));
  }

  // The point with number `k` on a face.
  static Point point(std::uint64_t number, std::uint64_t k, const Triangle& t) {
    const std::uint64_t first = mixed_hash(mixed_hash(number) ^ (k + 1));
    // Evenly over the triangle: Osada et al. 2002, formula 1.
    const double root = std::sqrt(chance(first));
    const double along = chance(mixed_hash(first));
    return (1 - root) * t[0] + (root * (1 - along) * t[1] + root * along * t[2]);
  }

 private:
  // From 0 to below 1.
  static double chance(std::uint64_t hash) { return static_cast<double>(hash >> 11) * 0x1p-53; }

  double density_;
};

}  // namespace winnow
