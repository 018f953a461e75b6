#include "cluster/weld_lattice.hpp"

#include <algorithm>

namespace winnow {

CellKey key_of(const Grid& grid, const Point& p) {
  const auto cell = [&](std::size_t axis) {
    return static_cast<std::uint32_t>(
        std::clamp<double>(grid.cell_of(p[axis], axis), 0, axis_cells - 1));
  };
  return morton_key(cell(0), cell(1), cell(2));
}

Grid lattice_over(const Box& box) {
  const double side = box.longest_side();
  return Grid::over(box, side > 0 ? Grid::edge_for(box, axis_cells / 2) : 1);
}

}  // namespace winnow
