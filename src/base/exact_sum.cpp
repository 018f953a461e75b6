#include "base/exact_sum.hpp"

#include <bit>
#include <cmath>

namespace winnow {

void ExactSum::add(double value) {
  if (value == 0) return;
  const auto bits = std::bit_cast<std::uint64_t>(value);
  const auto exponent = static_cast<unsigned>(bits >> 52 & 0x7ff);
  const std::uint64_t mantissa =
      (bits & 0x000fffffffffffff) | (exponent == 0 ? 0 : std::uint64_t{1} << 52);
  // The mantissa's lowest bit stands for 2^(place - 1074).
  const unsigned place = exponent == 0 ? 0 : exponent - 1;
  const unsigned shift = place % 32;
  const std::size_t at = place / 32;
  const std::uint64_t low = mantissa << shift;  // at most 53 + 31 bits: the rest is in `high`
  const std::uint64_t high = shift == 0 ? 0 : mantissa >> (64 - shift);
  const std::int64_t sign = value < 0 ? -1 : 1;
  digit_[at] += sign * static_cast<std::int64_t>(low & 0xffffffff);
  digit_[at + 1] += sign * static_cast<std::int64_t>(low >> 32);
  digit_[at + 2] += sign * static_cast<std::int64_t>(high);
  if (++pending_ == 0x7fffffff) settle();
}

void ExactSum::settle() {
  for (std::size_t i = 0; i + 1 < digits; ++i) {
    const std::int64_t carry =
        digit_[i] >> 32;  // towards minus infinity: what stays is not negative
    digit_[i] -= carry * (std::int64_t{1} << 32);
    digit_[i + 1] += carry;
  }
  pending_ = 0;
}

void ExactSum::merge(const ExactSum& other) {
  ExactSum settled = other;
  settled.settle();
  settle();
  for (std::size_t i = 0; i < digits; ++i) digit_[i] += settled.digit_[i];
}

double ExactSum::value() const {
  ExactSum whole = *this;
  whole.settle();
  const bool negative = whole.digit_.back() < 0;
  if (negative) {
    for (std::int64_t& digit : whole.digit_) digit = -digit;
    whole.settle();
  }
  std::size_t top = digits;
  while (top > 0 && whole.digit_[top - 1] == 0) --top;
  // Three digits hold 64 bits and more of the leading ones; the rest cannot change more than the
  // last bit.
  double sum = 0;
  for (std::size_t i = top < 3 ? 0 : top - 3; i < top; ++i) {
    sum += std::ldexp(static_cast<double>(whole.digit_[i]), static_cast<int>(32 * i) - 1074);
  }
  return negative ? -sum : sum;
}

}  // namespace winnow
