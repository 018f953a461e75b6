// Attributes as whole numbers: means of equal numbers are that number, whatever its type and size.
#include "base/srgb.hpp"
#include "cluster/attribute_scale.hpp"
#include "support/random.hpp"

#include <cmath>
#include <limits>

#include <catch2/catch.hpp>

namespace winnow::test {

namespace {

double mean_of_equal(const AttributeScale& scale, const Attribute& attribute, double stored,
                     std::uint64_t weight) {
  const Int128 sum = static_cast<Int128>(scale.fixed(stored)) * static_cast<Int128>(weight);
  return stored_of_mean(attribute, scale.mean(sum, weight));
}

}  // namespace

TEST_CASE("the mean of equal numbers is that number") {
  Random random(7);
  for (const double largest : {1.0, 3.5e38, 1e-30, 1e300, 1e-300}) {
    const Attribute attribute{"quality", NumberType::float64, AttributeKind::value};
    const AttributeScale scale(attribute, largest);
    for (int i = 0; i < 1000; ++i) {
      const double value =
          largest * std::ldexp(1 + random.unit(), -1 - i % 9) * (i % 2 == 0 ? 1 : -1);
      REQUIRE(mean_of_equal(scale, attribute, value, random.between(1, std::uint64_t{1} << 41)) ==
              value);
    }
    CHECK(mean_of_equal(scale, attribute, 0, 3) == 0);
    CHECK(mean_of_equal(scale, attribute, largest, 3) == largest);
  }
}

TEST_CASE("floats far below the largest are still exact") {
  const Attribute attribute{"quality", NumberType::float32, AttributeKind::value};
  const AttributeScale scale(attribute, 1e10);
  const double small = 0.1F;
  CHECK(mean_of_equal(scale, attribute, small, 12345) == small);
}

TEST_CASE("every colour of 8 and 16 bits comes back from its mean") {
  for (const NumberType type : {NumberType::uint8, NumberType::uint16}) {
    const Attribute attribute{"red", type, AttributeKind::color};
    const double full = type == NumberType::uint8 ? 255 : 65535;
    const AttributeScale scale(attribute, full);
    int wrong = 0;
    for (int i = 0; i <= full; ++i)
      wrong += std::nearbyint(mean_of_equal(scale, attribute, i, 77)) != i;
    CHECK(wrong == 0);
  }
}

TEST_CASE("the mean of black and white has half the light") {
  const Attribute attribute{"red", NumberType::uint8, AttributeKind::color};
  const AttributeScale scale(attribute, 255);
  const double mean = scale.mean(static_cast<Int128>(scale.fixed(255)) + scale.fixed(0), 2);
  CHECK(mean == Approx(0.5));
  CHECK(std::nearbyint(stored_of_mean(attribute, mean)) == 188);
}

TEST_CASE("what is not finite is told apart") {
  const AttributeScale scale({"quality", NumberType::float32, AttributeKind::value}, 4);
  for (const double value :
       {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity(),
        -std::numeric_limits<double>::infinity()})
    CHECK(scale.fixed(value) == AttributeScale::none);
  CHECK(scale.fixed(-4) != AttributeScale::none);
}

TEST_CASE("light is averaged as it is, and written as a colour") {
  for (const NumberType type : {NumberType::uint8, NumberType::uint16, NumberType::float32}) {
    const Attribute attribute{"red", type, AttributeKind::light};
    const double full = full_component(type);
    const AttributeScale scale(attribute, full);
    const double low = type == NumberType::uint8 ? 51 : 0.2 * full;
    const double mean = scale.mean(Int128{scale.fixed(0)} + scale.fixed(low), 2);
    CHECK(mean == Approx(low / full / 2));
    CHECK(stored_of_mean(attribute, mean) == Approx(full * component_of_light(low / full / 2)));
    CHECK(mean_of_stored(attribute, low) == low / full);
  }
}

}  // namespace winnow::test
