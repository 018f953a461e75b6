#include "cluster/written_rounding.hpp"

#include "base/hash.hpp"

#include <algorithm>
#include <bit>
#include <charconv>
#include <cmath>
#include <string>

namespace winnow {

namespace {

constexpr double smallest_part = 0x1p-16;  // of a box, that rounding may be
constexpr int most_digits = 15;            // that are rounded, not all of a double
constexpr std::uint64_t looked_at = 4;     // one value in so many

// To the bit, which std::pow() does not promise.
double power_of_ten(int exponent) {
  const std::string text = "1e" + std::to_string(exponent);
  double power = 0;
  std::from_chars(text.data(), text.data() + text.size(), power);
  return power;
}

}  // namespace

void WrittenRounding::add(double coordinate) {
  if (all_digits_ || static_cast<double>(static_cast<float>(coordinate)) == coordinate) return;
  if (mixed_hash(std::bit_cast<std::uint64_t>(coordinate)) % looked_at == 0) look(coordinate);
}

// The shortest digits that give the same double.
void WrittenRounding::look(double coordinate) {
  std::array<char, 32> text{};
  const auto [end, error] = std::to_chars(text.data(), text.data() + text.size(),
                                          std::abs(coordinate), std::chars_format::scientific);
  const char* exponent = std::find(text.data(), end, 'e');
  if (exponent == end) return;
  int decade = 0;
  std::from_chars(exponent[1] == '+' ? exponent + 2 : exponent + 1, end, decade);
  const auto digits = static_cast<int>(exponent - text.data()) - (exponent - text.data() > 1);
  if (digits > most_digits) {
    all_digits_ = true;
    return;
  }
  const int last = decade - (digits - 1);
  const double off = std::abs(static_cast<double>(static_cast<float>(coordinate)) - coordinate);
  floats_ = floats_ && off <= 0.501 * power_of_ten(last);
  digits_ = std::max(digits_, digits);
  last_ = std::min(last_, last);
  if (decade > top_) {
    top_ = decade;
    last_of_top_ = last;
  } else if (decade == top_) {
    last_of_top_ = std::min(last_of_top_, last);
  }
}

void WrittenRounding::add(const WrittenRounding& other) {
  all_digits_ = all_digits_ || other.all_digits_;
  floats_ = floats_ && other.floats_;
  digits_ = std::max(digits_, other.digits_);
  last_ = std::min(last_, other.last_);
  if (other.top_ == top_) last_of_top_ = std::min(last_of_top_, other.last_of_top_);
  if (other.top_ > top_) {
    top_ = other.top_;
    last_of_top_ = other.last_of_top_;
  }
}

CoordinateRounding WrittenRounding::rounding(double side, double largest) const {
  CoordinateRounding out;
  if (all_digits_) return out;
  if (floats_) out.relative = rounding_of_float;
  if (digits_ > 0) {
    // So many decimals, or so many digits.
    if (last_of_top_ == last_) {
      out.absolute = power_of_ten(last_);
    } else {
      out.relative = std::max(out.relative, power_of_ten(1 - digits_));
    }
  }
  if (out.relative * largest + out.absolute > smallest_part * side) return {};
  return out;
}

}  // namespace winnow
