// What sampling for the cell size does with every position. As corner_kernel.hpp: compiled once for
// each instruction set, the same results from all, and no function may be defined here.
#pragma once

#include <cstddef>
#include <cstdint>

namespace winnow {

// Up to kernel_capacity positions, one array an axis.
struct PositionInput {
  const double* axis[3];
  std::size_t count;
};

struct PositionKernel {
  // Lowest and highest coordinates, and whether all are finite; if not, the box says nothing.
  bool (*box)(const PositionInput& input, double (&low)[3], double (&high)[3]);

  // PackedCell of each position; -1 where it is not finite or outside of the lattice.
  void (*cells)(const PositionInput& input, const double (&origin)[3], double inverse,
                std::int64_t* packed);
};

extern const PositionKernel position_kernel_baseline;
extern const PositionKernel position_kernel_avx2;
extern const PositionKernel position_kernel_avx512;

// The widest that this processor runs.
const PositionKernel& best_position_kernel();

}  // namespace winnow
