#include "cluster/attribute_scale.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace winnow {

namespace {

constexpr int mean_bits = 62;

}  // namespace

AttributeScale::AttributeScale(const Attribute& attribute, double largest) : attribute_(attribute) {
  if (is_label()) {
    up_.fill(1);
    down_.fill(1);
    return;
  }
  int exponent = 0;
  std::frexp(std::min(mean_of_stored(attribute, largest), std::numeric_limits<double>::max()),
             &exponent);
  const int shift = mean_bits - exponent;
  const std::array<int, 2> half{shift / 2, shift - shift / 2};
  for (std::size_t i = 0; i < half.size(); ++i) {
    up_[i] = std::ldexp(1, half[i]);
    down_[i] = std::ldexp(1, -half[i]);
  }
  if (!is_color(attribute) || !is_integer(attribute.type)) return;
  table_.resize(std::size_t{1} << (8 * size_of(attribute.type)));
  for (std::size_t i = 0; i < table_.size(); ++i)
    table_[i] = scaled(mean_of_stored(attribute, static_cast<double>(i)));
}

double AttributeScale::mean(Int128 sum, std::uint64_t weight) const {
  // Divided as whole numbers, so that the mean of equal numbers is that number.
  const auto divisor = static_cast<Int128>(weight);
  const Int128 half = sum < 0 ? -divisor / 2 : divisor / 2;
  return static_cast<double>(static_cast<std::int64_t>((sum + half) / divisor)) * down_[0] *
         down_[1];
}

std::vector<AttributeScale> scales_of(const CarriedAttributes& carried) {
  std::vector<AttributeScale> scales;
  for (std::size_t i = 0; i < carried.attributes.size(); ++i)
    scales.emplace_back(carried.attributes[i], carried.largest[i]);
  return scales;
}

}  // namespace winnow
