// Compiled once for each instruction set, with WINNOW_KERNEL naming it (src/CMakeLists.txt).
#include "cluster/kernel/area_kernel.hpp"

#include <math.h>

#define WINNOW_JOIN2(a, b) a##b
#define WINNOW_JOIN(a, b) WINNOW_JOIN2(a, b)

namespace winnow {

namespace {

constexpr double most_units = 0x1p48;
// Added to a number below 2^51, it leaves the nearest whole number in the low bits of the sum.
constexpr double rounding = 0x1.8p52;

template <typename Real>
void doubled_areas_of(const Real* const (&position)[3][3], std::size_t count, double* doubled) {
  const Real* ax = position[0][0];
  const Real* ay = position[0][1];
  const Real* az = position[0][2];
  const Real* bx = position[1][0];
  const Real* by = position[1][1];
  const Real* bz = position[1][2];
  const Real* cx = position[2][0];
  const Real* cy = position[2][1];
  const Real* cz = position[2][2];
  for (std::size_t i = 0; i < count; ++i) {
    const double ux = double{bx[i]} - double{ax[i]}, vx = double{cx[i]} - double{ax[i]};
    const double uy = double{by[i]} - double{ay[i]}, vy = double{cy[i]} - double{ay[i]};
    const double uz = double{bz[i]} - double{az[i]}, vz = double{cz[i]} - double{az[i]};
    const double x = uy * vz - uz * vy, y = uz * vx - ux * vz, z = ux * vy - uy * vx;
    doubled[i] = sqrt(x * x + y * y + z * z);
  }
}

void doubled_areas(const AreaInput& input, double* doubled) {
  if (input.single) {
    doubled_areas_of(input.single_position, input.count, doubled);
  } else {
    doubled_areas_of(input.position, input.count, doubled);
  }
}

bool add_up(const double* doubled, std::size_t count, double scale, std::uint64_t& units) {
  // Without a sign: it may overflow where not all are small, and does not count then.
  std::uint64_t sum = 0;
  std::int64_t small = 1;
  for (std::size_t i = 0; i < count; ++i) {
    const double scaled = 0.5 * doubled[i] * scale;
    sum += __builtin_bit_cast(std::uint64_t, scaled + rounding) -
           __builtin_bit_cast(std::uint64_t, rounding);
    small &= scaled < most_units ? 1 : 0;
  }
  units = sum;
  return small != 0;
}

}  // namespace

extern const AreaKernel WINNOW_JOIN(area_kernel_, WINNOW_KERNEL) = {doubled_areas, add_up};

}  // namespace winnow
