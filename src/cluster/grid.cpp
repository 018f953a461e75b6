#include "cluster/grid.hpp"

#include <winnow/error.hpp>

#include "base/text.hpp"
#include "cluster/kernel/corner_kernel.hpp"

#include <cmath>

namespace winnow {

double Grid::rounded_place(double coordinate, std::size_t axis) const {
  constexpr double scale = 1 << fraction_bits;
  return std::nearbyint((coordinate - origin[axis]) * (inverse * scale)) / scale;
}

double Grid::cell_of(double coordinate, std::size_t axis) const {
  return std::floor(rounded_place(coordinate, axis));
}

void refuse_cell(double cell, double side) {
  // A part in a thousand more, so that the named edge works whatever is rounded on the way.
  throw Error(ErrorKind::usage,
              "cells of " + shortest(cell) + " are too small for a model " + shortest(side) +
                  " across: at most 2,097,152 cells an axis; the smallest that work are " +
                  shortest(side / axis_cells * 1.001));
}

namespace {
Grid with_cell(double cell) {
  Grid grid;
  grid.cell = cell;
  grid.inverse = 1 / cell;
  if (!std::isfinite(grid.inverse) || grid.inverse == 0) {
    throw Error(ErrorKind::usage, "a cell of " + shortest(cell) + " is out of any range");
  }
  return grid;
}
}  // namespace

Grid Grid::around(const std::array<double, 3>& first, double cell) {
  Grid grid = with_cell(cell);
  constexpr double half = axis_cells / 2;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    grid.origin[axis] = (std::floor(first[axis] * grid.inverse) - half) * cell;
    // Where a step of one cell is below what a double holds, cells lose their meaning.
    if (!(std::abs(first[axis]) * grid.inverse < 4.0e15)) {
      throw Error(ErrorKind::usage, "cells of " + shortest(cell) +
                                        " are too small for coordinates like " +
                                        shortest(first[axis]));
    }
  }
  return grid;
}

Grid Grid::over(const Box& box, double cell) {
  Grid grid = with_cell(cell);
  grid.origin = box.low;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    if (!(grid.cell_of(box.high[axis], axis) < axis_cells)) refuse_cell(cell, box.longest_side());
  }
  return grid;
}

double Grid::edge_for(const Box& box, std::uint64_t cells) {
  const double side = box.longest_side();
  if (!(side > 0)) return 1;  // a single point: any cell holds it
  // Two of the lattice's smallest steps short of the last cell's end.
  return side / (static_cast<double>(cells) - 0x1p-21);
}

}  // namespace winnow
