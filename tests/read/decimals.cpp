// Whether floats say the same as decimal numbers do.
#include "read/text/decimal.hpp"
#include "read/text/tokens.hpp"
#include "support/random.hpp"

#include <array>
#include <cmath>
#include <cstring>

#include <catch2/catch.hpp>

namespace winnow {

namespace {

bool says(const std::string& word) {
  return float_says_it(word, parse_real(word).value());
}

std::string printed(const char* form, double value) {
  std::array<char, 400> text{};
  std::snprintf(text.data(), text.size(), form, value);
  return text.data();
}

}  // namespace

TEST_CASE("what is written of floats is said by floats") {
  test::Random random(410);
  for (int i = 0; i < 20'000; ++i) {
    const auto bits = static_cast<std::uint32_t>(random.bits());
    float value = 0;
    std::memcpy(&value, &bits, sizeof value);
    if (!std::isfinite(value)) continue;
    for (const char* form : {"%.9g", "%.17g", "%.6g", "%.3g", "%.8e", "%+.9g"}) {
      CAPTURE(printed(form, double{value}));
      CHECK(says(printed(form, double{value})));
    }
    const double coordinate = static_cast<float>(random.real(-1000, 1000));
    CHECK(says(printed("%f", coordinate)));
    CHECK(says(printed("%.10f", coordinate)));
  }
}

TEST_CASE("what floats do not hold needs doubles") {
  test::Random random(411);
  for (int i = 0; i < 20'000; ++i) {
    const double millimetres = std::floor(random.real(4e9, 6e9)) / 1000;
    const std::string text = printed("%.3f", millimetres);
    CAPTURE(text);
    CHECK(says(text) ==
          (std::abs(double{static_cast<float>(millimetres)} - millimetres) <= 0.0005));
  }
  for (const char* word :
       {"0.1234567891", "16777217", "1e39", "5000000.3", "3.14159265358979", "-1.0000000001"})
    CHECK_FALSE(says(word));
}

TEST_CASE("the last digits of a double are not taken for what was meant") {
  for (const char* word : {"-0.037829700000000001", "0.15124399999999999"}) CHECK(says(word));
  for (const char* word :
       {"0", "-0.0", "1.", ".5", "1e2", "nan", "inf", "-inf", "1e-400", "0e9999999999"})
    CHECK(says(word));
}

}  // namespace winnow
