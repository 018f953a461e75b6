// Compiled once for each instruction set, with WINNOW_KERNEL naming it (src/CMakeLists.txt).
#include "cluster/kernel/position_kernel.hpp"

#define WINNOW_JOIN2(a, b) a##b
#define WINNOW_JOIN(a, b) WINNOW_JOIN2(a, b)

namespace winnow {

namespace {

// As in base/morton.hpp, which defines functions and so may not be included here.
constexpr int axis_bits = 21;
constexpr double axis_cells = 1 << axis_bits;

// Doubles as whole numbers in the same order, because a minimum of whole numbers vectorises without
// leave to reassociate; the same function leads back.
inline std::int64_t ordered(std::int64_t bits) {
  return bits ^ (bits >> 63 & INT64_MAX);
}

bool box(const PositionInput& input, double (&low)[3], double (&high)[3]) {
  constexpr std::int64_t infinity = 0x7ff0000000000000;
  const std::size_t count = input.count;
  std::int64_t largest = 0;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const double* p = input.axis[axis];
    std::int64_t lowest = INT64_MAX;
    std::int64_t highest = INT64_MIN;
    for (std::size_t i = 0; i < count; ++i) {
      const auto bits = __builtin_bit_cast(std::int64_t, p[i]);
      const std::int64_t size = bits & INT64_MAX;
      const std::int64_t place = ordered(bits);
      largest = size > largest ? size : largest;
      lowest = place < lowest ? place : lowest;
      highest = place > highest ? place : highest;
    }
    low[axis] = __builtin_bit_cast(double, ordered(lowest));
    high[axis] = __builtin_bit_cast(double, ordered(highest));
  }
  return largest < infinity;
}

void cells(const PositionInput& input, const double (&origin)[3], double inverse,
           std::int64_t* packed) {
  const double* px = input.axis[0];
  const double* py = input.axis[1];
  const double* pz = input.axis[2];
  const double ox = origin[0], oy = origin[1], oz = origin[2];
  const std::size_t count = input.count;
  for (std::size_t i = 0; i < count; ++i) {
    const double x = (px[i] - ox) * inverse;
    const double y = (py[i] - oy) * inverse;
    const double z = (pz[i] - oz) * inverse;
    const bool inside =
        (x >= 0) & (x < axis_cells) & (y >= 0) & (y < axis_cells) & (z >= 0) & (z < axis_cells);
    const std::int64_t cell = std::int64_t{static_cast<std::int32_t>(inside ? x : 0)} |
                              std::int64_t{static_cast<std::int32_t>(inside ? y : 0)} << axis_bits |
                              std::int64_t{static_cast<std::int32_t>(inside ? z : 0)}
                                  << (2 * axis_bits);
    packed[i] = inside ? cell : -1;
  }
}

}  // namespace

extern const PositionKernel WINNOW_JOIN(position_kernel_, WINNOW_KERNEL) = {box, cells};

}  // namespace winnow
