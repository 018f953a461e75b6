#include "cluster/weld_lattice.hpp"

#include "cluster/kernel/corner_kernel.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace winnow {

CellKey key_of(const Grid& grid, const Point& p) {
  // As Grid::cell_of(), by whole numbers: without a call.
  constexpr double scale = 1 << fraction_bits;
  const auto cell = [&](std::size_t axis) {
    const double place = (p[axis] - grid.origin[axis]) * (grid.inverse * scale);
    const auto rounded = std::llrint(std::clamp(place, -scale, axis_cells * scale));
    return static_cast<std::uint32_t>(
        std::clamp<std::int64_t>(rounded >> fraction_bits, 0, axis_cells - 1));
  };
  return morton_key(cell(0), cell(1), cell(2));
}

Grid lattice_over(const Box& box) {
  const double side = box.longest_side();
  return Grid::over(box, side > 0 ? Grid::edge_for(box, axis_cells / 2) : 1);
}

}  // namespace winnow
