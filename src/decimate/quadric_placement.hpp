// What the costs by quadrics have in common.
#pragma once

#include "base/quadric.hpp"
#include "decimate/collapser.hpp"

#include <cstddef>
#include <span>
#include <vector>

namespace winnow {

// Where planes cost nothing, as on flat parts, short edges go first: the square of the length
// counts, by this part of the planes' weight.
inline constexpr double edge_length_share = 1e-6;

// Draws the lowest point towards the middle of the edge, as a part of the planes' weight: as in
// kernel/edge_kernel.cpp.
inline constexpr double placement_pull = 1e-4;

// Of the line of an edge at a boundary, with the square of its length, beside the areas of faces.
inline constexpr double boundary_line_weight = 0.5;

// The lowest point of a quadric seen from `low`, an end of `edge`, as a position. `pull` draws it
// towards the middle of the edge where the planes leave it free, as a part of their weight.
// `single`: in numbers that floats have.
inline Point lowest_position(const Quadric& quadric, double pull, const Point& low,
                             const Point& edge, bool single) {
  const double weight = quadric.weight();
  const Point middle = 0.5 * edge;
  Point position = low + (weight > 0 ? lowest_point(quadric, pull * weight, middle) : middle);
  if (single) {
    for (double& x : position) x = nearest_float(x);
  }
  return finite(position) ? position : low;
}

}  // namespace winnow
