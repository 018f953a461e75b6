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

// A power of two, so that no sum of whole numbers is rounded on its way back.
double scale_for(double unit) {
  if (!(unit > 0) || !std::isnormal(fraction / unit)) return 0;
  return std::ldexp(1.0, std::ilogb(fraction / unit));
}

}  // namespace

AreaSum::AreaSum(unsigned threads, double unit)
    : kernel_(best_area_kernel()),
      scale_(scale_for(unit)),
      parts_(threads, [] { return std::make_unique<Part>(); }) {}

void AreaSum::add(const FaceBatch& faces) {
  AreaInput input{};
  for (std::size_t corner = 0; corner < 3; ++corner) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      input.single_position[corner][axis] = faces.single_position[corner][axis].data();
      input.position[corner][axis] = faces.position[corner][axis].data();
    }
  }
  input.single = faces.single;
  input.count = faces.count;
  alignas(64) std::array<double, FaceBatch::capacity> area;
  kernel_.doubled_areas(input, area.data());
  if (!faces.all_good) {
    for (std::size_t i = 0; i < faces.count; ++i) {
      if (faces.status[i] != FaceStatus::good) area[i] = 0;
    }
  }
  Part& part = parts_.local();
  std::uint64_t units = 0;
  if (scale_ > 0 && kernel_.add_up(area.data(), faces.count, scale_, units)) {
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
