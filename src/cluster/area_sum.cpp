#include "cluster/area_sum.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>

namespace winnow {

namespace {

constexpr double fraction = 0x1p40;
constexpr double most_units = 0x1p48;
// Added to a number below 2^51, it leaves the nearest whole number in the low bits of the sum.
constexpr double rounding = 0x1.8p52;

// Twice the area of each face. Not finite where a corner is not.
template <typename Real>
void doubled_areas(const FaceBatch::Positions<Real>& p, std::size_t count,
                   std::array<double, FaceBatch::capacity>& area) {
  for (std::size_t i = 0; i < count; ++i) {
    const double ux = double{p[1][0][i]} - double{p[0][0][i]},
                 vx = double{p[2][0][i]} - double{p[0][0][i]};
    const double uy = double{p[1][1][i]} - double{p[0][1][i]},
                 vy = double{p[2][1][i]} - double{p[0][1][i]};
    const double uz = double{p[1][2][i]} - double{p[0][2][i]},
                 vz = double{p[2][2][i]} - double{p[0][2][i]};
    const double x = uy * vz - uz * vy, y = uz * vx - ux * vz, z = ux * vy - uy * vx;
    area[i] = std::sqrt(x * x + y * y + z * z);
  }
}

// A power of two, so that no sum of whole numbers is rounded on its way back.
double scale_for(double unit) {
  if (!(unit > 0) || !std::isnormal(fraction / unit)) return 0;
  return std::ldexp(1.0, std::ilogb(fraction / unit));
}

}  // namespace

AreaSum::AreaSum(unsigned threads, double unit)
    : scale_(scale_for(unit)), parts_(threads, [] { return std::make_unique<Part>(); }) {}

void AreaSum::add(const FaceBatch& faces) {
  alignas(64) std::array<double, FaceBatch::capacity> area;
  if (faces.single) {
    doubled_areas(faces.single_position, faces.count, area);
  } else {
    doubled_areas(faces.position, faces.count, area);
  }
  if (!faces.all_good) {
    for (std::size_t i = 0; i < faces.count; ++i) {
      if (faces.status[i] != FaceStatus::good) area[i] = 0;
    }
  }
  Part& part = parts_.local();
  // Without a sign: it may overflow where not all are small, and does not count then.
  std::uint64_t units = 0;
  std::int64_t small = scale_ > 0 ? 1 : 0;
  for (std::size_t i = 0; i < faces.count; ++i) {
    const double scaled = 0.5 * area[i] * scale_;
    units +=
        std::bit_cast<std::uint64_t>(scaled + rounding) - std::bit_cast<std::uint64_t>(rounding);
    small &= static_cast<std::int64_t>(scaled < most_units);
  }
  if (small != 0) {
    part.units += static_cast<std::int64_t>(units);
  } else {
    for (std::size_t i = 0; i < faces.count; ++i) {
      const double scaled = 0.5 * area[i] * scale_;
      if (scale_ > 0 && scaled < most_units) {
        part.units +=
            std::bit_cast<std::int64_t>(scaled + rounding) - std::bit_cast<std::int64_t>(rounding);
      } else if (std::isfinite(area[i])) {
        part.large.add(0.5 * area[i]);
      }
    }
  }
  // Room for any batch that follows.
  if (part.units >= std::int64_t{1} << 62) {
    constexpr std::int64_t half = std::int64_t{1} << 62;
    part.units -= half;
    part.large.add(static_cast<double>(half) / scale_);
  }
}

double AreaSum::value() const {
  ExactSum sum;
  for (const Part* part : parts_.all()) sum.merge(part->large);
  // Whole numbers first, so that the threads' shares do not show.
  std::int64_t high = 0, low = 0;
  constexpr std::int64_t step = std::int64_t{1} << 32;
  for (const Part* part : parts_.all()) {
    high += part->units / step;
    low += part->units % step;
  }
  if (scale_ > 0) {
    high += low / step;
    low %= step;
    sum.add(static_cast<double>(high) * (static_cast<double>(step) / scale_));
    sum.add(static_cast<double>(low) / scale_);
  }
  return sum.value();
}

}  // namespace winnow
