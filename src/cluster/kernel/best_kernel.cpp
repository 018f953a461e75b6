#include "base/instruction_set.hpp"
#include "cluster/kernel/corner_kernel.hpp"
#include "cluster/kernel/position_kernel.hpp"

namespace winnow {

CornerKernel best_corner_kernel() {
  return best_kernel(corner_kernel_baseline, corner_kernel_avx2, corner_kernel_avx512);
}

const PositionKernel& best_position_kernel() {
  return *best_kernel(&position_kernel_baseline, &position_kernel_avx2, &position_kernel_avx512);
}

}  // namespace winnow
