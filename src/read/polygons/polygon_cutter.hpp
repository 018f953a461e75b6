// Polygons as triangles, concave ones too.
#pragma once

#include "base/pace.hpp"
#include "base/vector.hpp"

#include <array>
#include <cstdint>
#include <functional>
#include <span>
#include <utility>
#include <vector>

namespace winnow {

class PolygonCutter {
 public:
  // cut() asks whether to go on by `ask`, which throws if not.
  explicit PolygonCutter(std::function<void()> ask = {}) : pace_(std::move(ask)) {}

  // Bytes that cut() needs besides for so many corners.
  static constexpr std::uint64_t memory(std::uint64_t corners) { return 256 * corners; }

  // The triangles of a polygon of four corners or more, as numbers of its corners, in its own
  // sense. It is seen along the mean of its normals. A convex one is a fan around its first corner.
  // Nothing where it crosses itself, or where a corner is no number. Time: n log n.
  const std::vector<std::array<std::uint32_t, 3>>& cut(std::span<const Point> corners);

 private:
  [[nodiscard]] Point normal_of(std::span<const Point> corners);
  bool fan(std::span<const Point> corners);
  bool sweep(std::span<const Point> corners, double nudge);
  [[nodiscard]] bool covers(std::span<const Point> corners);

  Pace pace_;
  Point normal_{};   // of the polygon; as long as twice its area
  double most_ = 0;  // that rounding can make of a doubled area times normal_
  std::vector<std::array<std::uint32_t, 3>> triangles_;
};

}  // namespace winnow
