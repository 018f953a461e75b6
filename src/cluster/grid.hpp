// The lattice of cubic cells that vertices are clustered on.
#pragma once

#include "base/box.hpp"
#include "base/morton.hpp"

#include <array>
#include <cstdint>
#include <string>

namespace winnow {

// A position's place on the lattice is (position - origin) * inverse, rounded to whole 2^-22 cells;
// its cell is the whole part of that. This one formula, in double, decides everywhere.
struct Grid {
  std::array<double, 3> origin{};
  double cell = 0;     // edge of a cell, in model units
  double inverse = 0;  // 1 / cell

  // In cells, not rounded.
  [[nodiscard]] double place(double coordinate, std::size_t axis) const {
    return (coordinate - origin[axis]) * inverse;
  }

  // Rounded to what the lattice tells apart.
  [[nodiscard]] double rounded_place(double coordinate, std::size_t axis) const;

  // The whole part of the rounded place: what the corner kernel finds. Out of 0 to 2^21 - 1 for a
  // coordinate that is not on the lattice.
  [[nodiscard]] double cell_of(double coordinate, std::size_t axis) const;

  // With a cell edge and no box: the lattice point below the first finite vertex, less 2^20 cells,
  // so that a file and a pipe give the same lattice, with as much room on either side.
  static Grid around(const std::array<double, 3>& first, double cell);

  // With a box: from its lower corner. Throws Error(usage) if it needs more than 2^21 cells an
  // axis.
  static Grid over(const Box& box, double cell);

  // The cell edge that cuts the longest side into `cells`, so that the far end still falls into the
  // last.
  static double edge_for(const Box& box, std::uint64_t cells);
};

// Too few cells an axis for a box of this side; names the smallest edge that works.
[[noreturn]] void refuse_cell(double cell, double side);

}  // namespace winnow
