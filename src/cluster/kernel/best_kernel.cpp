#include "cluster/kernel/corner_kernel.hpp"

namespace winnow {

CornerKernel best_corner_kernel() {
  __builtin_cpu_init();
  if (__builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512dq") &&
      __builtin_cpu_supports("avx512bw") && __builtin_cpu_supports("avx512vl")) {
    return corner_kernel_avx512;
  }
  if (__builtin_cpu_supports("avx2")) return corner_kernel_avx2;
  return corner_kernel_baseline;
}

}  // namespace winnow
