// Areas of faces. As corner_kernel.hpp: compiled once for each instruction set, the same results
// from all, and no function may be defined here.
#pragma once

#include <cstddef>
#include <cstdint>

namespace winnow {

// Up to kernel_capacity faces, their positions either of float or of double: [corner][axis].
struct AreaInput {
  const float* single_position[3][3];
  const double* position[3][3];
  bool single;
  std::size_t count;
};

struct AreaKernel {
  // Twice the area of each face. Not finite where a corner is not.
  void (*doubled_areas)(const AreaInput& input, double* doubled);

  // The sum of half of each number, times `scale`, rounded to a whole one. False, and the sum says
  // nothing, where one is not below 2^48.
  bool (*add_up)(const double* doubled, std::size_t count, double scale, std::uint64_t& units);
};

extern const AreaKernel area_kernel_baseline;
extern const AreaKernel area_kernel_avx2;
extern const AreaKernel area_kernel_avx512;

// The widest that this processor runs.
const AreaKernel& best_area_kernel();

}  // namespace winnow
