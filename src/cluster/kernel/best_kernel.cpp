#include "cluster/kernel/corner_kernel.hpp"
#include "cluster/kernel/position_kernel.hpp"

namespace winnow {

namespace {

enum class Isa { baseline, avx2, avx512 };

Isa widest() {
  __builtin_cpu_init();
  if (__builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512dq") &&
      __builtin_cpu_supports("avx512bw") && __builtin_cpu_supports("avx512vl")) {
    return Isa::avx512;
  }
  return __builtin_cpu_supports("avx2") ? Isa::avx2 : Isa::baseline;
}

}  // namespace

CornerKernel best_corner_kernel() {
  switch (widest()) {
    case Isa::avx512:
      return corner_kernel_avx512;
    case Isa::avx2:
      return corner_kernel_avx2;
    default:
      return corner_kernel_baseline;
  }
}

const PositionKernel& best_position_kernel() {
  switch (widest()) {
    case Isa::avx512:
      return position_kernel_avx512;
    case Isa::avx2:
      return position_kernel_avx2;
    default:
      return position_kernel_baseline;
  }
}

}  // namespace winnow
