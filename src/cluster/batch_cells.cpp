#include "cluster/batch_cells.hpp"

#include <algorithm>

namespace winnow {

void BatchCells::find(const FaceBatch& faces, const Grid& grid) {
  const PositionKernel& kernel = best_position_kernel();
  const double origin[3] = {grid.origin[0], grid.origin[1], grid.origin[2]};
  for (std::size_t c = 0; c < 3; ++c) {
    PositionInput& input = input_[c];
    input.count = faces.count;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      input.axis[axis] = faces.position[c][axis].data();
      if (!faces.single) continue;
      std::copy_n(faces.single_position[c][axis].begin(), faces.count, position_[c][axis].begin());
      input.axis[axis] = position_[c][axis].data();
    }
    kernel.cells(input, origin, grid.inverse, cell_[c].data());
  }
}

}  // namespace winnow
