#include "cluster/attribute_scale.hpp"

#include <algorithm>
#include <cmath>

namespace winnow {

namespace {

constexpr int bits = 62;
// Beyond, the power of two or its inverse would not be a normal number.
constexpr int most_shift = 1000;

}  // namespace

AttributeScale::AttributeScale(const Attribute& attribute, double largest) : attribute_(attribute) {
  int exponent = 0;
  std::frexp(std::min(mean_of_stored(attribute, largest), 0x1p1000), &exponent);
  const int shift = std::min(bits - exponent, most_shift);
  up_ = std::ldexp(1, shift);
  down_ = std::ldexp(1, -shift);
  if (attribute.kind != AttributeKind::color || !is_integer(attribute.type)) return;
  table_.resize(std::size_t{1} << (8 * size_of(attribute.type)));
  for (std::size_t i = 0; i < table_.size(); ++i) table_[i] = computed(static_cast<double>(i));
}

std::int64_t AttributeScale::computed(double stored) const {
  const double scaled = mean_of_stored(attribute_, stored) * up_;
  return std::abs(scaled) <= 0x1p62 ? static_cast<std::int64_t>(scaled) : not_finite;
}

std::int64_t AttributeScale::fixed(double stored) const {
  return table_.empty() ? computed(stored) : table_[static_cast<std::size_t>(stored)];
}

double AttributeScale::mean(Int128 sum, std::uint64_t weight) const {
  // Divided as whole numbers, so that the mean of equal numbers is that number.
  const auto divisor = static_cast<Int128>(weight);
  const Int128 half = sum < 0 ? -divisor / 2 : divisor / 2;
  return static_cast<double>(static_cast<std::int64_t>((sum + half) / divisor)) * down_;
}

std::vector<AttributeScale> scales_of(const CarriedAttributes& carried) {
  std::vector<AttributeScale> scales;
  for (std::size_t i = 0; i < carried.attributes.size(); ++i)
    scales.emplace_back(carried.attributes[i], carried.largest[i]);
  return scales;
}

}  // namespace winnow
