// Numbers are written as the nearest that their type has.
#include "base/number_type.hpp"

#include <array>
#include <cmath>
#include <cstring>
#include <limits>

#include <catch2/catch.hpp>

namespace winnow {

namespace {

template <typename Number>
Number stored(double value, NumberType type) {
  REQUIRE(size_of(type) == sizeof(Number));
  std::array<std::byte, sizeof(Number)> bytes{};
  store_rounded(value, type, bytes.data());
  Number number{};
  std::memcpy(&number, bytes.data(), sizeof number);
  return number;
}

template <typename Number>
void check_whole(NumberType type) {
  using Limits = std::numeric_limits<Number>;
  CHECK(is_integer(type));
  CHECK(stored<Number>(1e300, type) == Limits::max());
  CHECK(stored<Number>(-1e300, type) == Limits::lowest());
  CHECK(stored<Number>(static_cast<double>(Limits::max()), type) == Limits::max());
  CHECK(stored<Number>(41.6, type) == 42);
  CHECK(stored<Number>(42.4, type) == 42);
  CHECK(stored<Number>(41.5, type) == 42);
  CHECK(stored<Number>(42.5, type) == 42);
}

}  // namespace

TEST_CASE("whole numbers are rounded to the nearest and end at their type's ends") {
  check_whole<std::int8_t>(NumberType::int8);
  check_whole<std::uint8_t>(NumberType::uint8);
  check_whole<std::int16_t>(NumberType::int16);
  check_whole<std::uint16_t>(NumberType::uint16);
  check_whole<std::int32_t>(NumberType::int32);
  check_whole<std::uint32_t>(NumberType::uint32);
}

TEST_CASE("real numbers are rounded to the nearest and stay finite, or what they are") {
  CHECK(stored<float>(0.1, NumberType::float32) == 0.1F);
  CHECK(stored<float>(1e300, NumberType::float32) == std::numeric_limits<float>::max());
  CHECK(stored<double>(0.1, NumberType::float64) == 0.1);
  constexpr double infinity = std::numeric_limits<double>::infinity();
  CHECK(stored<float>(-infinity, NumberType::float32) == -std::numeric_limits<float>::infinity());
  CHECK(stored<double>(infinity, NumberType::float64) == infinity);
  CHECK(std::isnan(stored<float>(std::nan(""), NumberType::float32)));
  CHECK(stored<std::int16_t>(std::nan(""), NumberType::int16) == 0);
  CHECK(stored<std::int16_t>(infinity, NumberType::int16) == 32767);
}

}  // namespace winnow
