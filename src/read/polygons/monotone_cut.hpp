// A polygon in the plane as triangles, by a sweep (Garey, Johnson, Preparata and Tarjan 1978; de
// Berg et al., Computational Geometry, chapter 3): diagonals cut it into parts that each vertical
// line meets once, and these are cut from left to right.
#pragma once

#include "base/pace.hpp"

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace winnow {

using PlanePoint = std::array<double, 2>;

// Appends the triangles, as numbers of corners, all of positive sense. The corners are in positive
// sense, too. Of a polygon that crosses or touches itself any triangles come, or fewer. Time: n log
// n. Each step is one of `pace`.
void cut_by_sweep(std::span<const PlanePoint> corners, Pace& pace,
                  std::vector<std::array<std::uint32_t, 3>>& triangles);

}  // namespace winnow
