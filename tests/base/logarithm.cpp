// Our own logarithm against the C library's.
#include "base/logarithm.hpp"

#include "support/random.hpp"

#include <cmath>
#include <limits>

#include <catch2/catch.hpp>

namespace winnow {

namespace {
void check_near(double value) {
  const double right = std::log(value);
  CAPTURE(value, right, natural_logarithm(value));
  REQUIRE(std::abs(natural_logarithm(value) - right) <= 1e-14 * std::abs(right));
}
}  // namespace

TEST_CASE("logarithms agree with the library's to a part in 10^14") {
  test::Random random(4);
  for (int i = 0; i < 20000; ++i)
    check_near(std::ldexp(random.real(0.5, 1), static_cast<int>(random.between(0, 2000)) - 1000));
  check_near(std::numeric_limits<double>::min());
  check_near(std::numeric_limits<double>::max());
}

TEST_CASE("logarithms near 1 keep their relative precision") {
  test::Random random(5);
  for (int i = 0; i < 20000; ++i) {
    const double off = std::ldexp(random.real(0.5, 1), -static_cast<int>(random.between(1, 52)));
    check_near(1 + off);
    check_near(1 - off);
  }
  CHECK(natural_logarithm(1) == 0);
  CHECK(natural_logarithm(std::nextafter(1, 2)) > 0);
  CHECK(natural_logarithm(std::nextafter(1, 0)) < 0);
}

TEST_CASE("logarithms are right where the series changes its piece") {
  for (int exponent = -60; exponent <= 60; ++exponent) {
    double value = std::ldexp(std::sqrt(2.0), exponent);
    for (int i = 0; i < 8; ++i) value = std::nextafter(value, 0.0);
    for (int i = 0; i < 16; ++i, value = std::nextafter(value, HUGE_VAL)) {
      if (value != 1) check_near(value);
    }
    if (exponent != 0) check_near(std::ldexp(1, exponent));
  }
}

}  // namespace winnow
