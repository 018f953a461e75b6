#include "base/instruction_set.hpp"
#include "cluster/kernel/area_kernel.hpp"
#include "cluster/kernel/corner_kernel.hpp"
#include "cluster/kernel/position_kernel.hpp"

namespace winnow {

CornerKernel best_corner_kernel() {
  return best_kernel(WINNOW_KERNELS(corner_kernel));
}

const PositionKernel& best_position_kernel() {
  return *best_kernel(WINNOW_KERNELS(&position_kernel));
}

const AreaKernel& best_area_kernel() {
  return *best_kernel(WINNOW_KERNELS(&area_kernel));
}

}  // namespace winnow
