#include "read/text/decimal.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstddef>

namespace winnow {

namespace {

// 1, 10, 100, ... A hair of rounding in the large ones does not matter here.
constexpr std::size_t most_digits = 308;
constexpr auto powers_of_ten = [] {
  std::array<double, most_digits + 1> powers{};
  powers[0] = 1;
  for (std::size_t i = 1; i < powers.size(); ++i) powers[i] = powers[i - 1] * 10;
  return powers;
}();

struct Digits {
  int count = 0;     // significant or leading zeros
  int exponent = 0;  // of the last one: "0.25" and "25e-2" have -2
};

Digits digits_of(std::string_view word) {
  Digits digits;
  std::size_t at = 0;
  bool behind_point = false;
  for (; at < word.size() && word[at] != 'e' && word[at] != 'E'; ++at) {
    if (word[at] == '.') {
      behind_point = true;
    } else if (word[at] >= '0' && word[at] <= '9') {
      ++digits.count;
      digits.exponent -= behind_point ? 1 : 0;
    }
  }
  if (at < word.size()) ++at;
  if (at < word.size() && word[at] == '+') ++at;
  int exponent = 0;
  std::from_chars(word.data() + at, word.data() + word.size(), exponent);
  digits.exponent += std::clamp(exponent, -1000, 1000);
  return digits;
}

// Half a unit of the last digit, and a hair for the arithmetic.
bool within(double miss, const Digits& digits) {
  constexpr double half = 0.5000001;
  const auto power = static_cast<std::size_t>(std::abs(digits.exponent));
  if (power > most_digits) return digits.exponent > 0;
  return digits.exponent < 0 ? miss * powers_of_ten[power] <= half
                             : miss <= half * powers_of_ten[power];
}

}  // namespace

bool float_says_it(std::string_view word, double value) {
  const auto single = static_cast<float>(value);
  if (single == value || !std::isfinite(value)) return true;
  if (!std::isfinite(single)) return false;
  // `value` itself is rounded by so much.
  const double miss = std::max(0.0, std::abs(value - single) - std::abs(value) * 0x1p-53);
  const Digits digits = digits_of(word);
  if (within(miss, digits)) return true;
  if (digits.count < 16) return false;
  std::array<char, 32> shortest{};
  const auto [end, error] =
      std::to_chars(shortest.data(), shortest.data() + shortest.size(), value);
  return error == std::errc{} && within(miss, digits_of({shortest.data(), end}));
}

}  // namespace winnow
