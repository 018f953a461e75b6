#include "base/number_type.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <limits>

namespace winnow {

namespace {

struct TypeFacts {
  const char* name;
  std::size_t size;
};
constexpr std::array<TypeFacts, 10> facts{{{"char", 1},
                                           {"uchar", 1},
                                           {"short", 2},
                                           {"ushort", 2},
                                           {"int", 4},
                                           {"uint", 4},
                                           {"int64", 8},
                                           {"uint64", 8},
                                           {"float", 4},
                                           {"double", 8}}};

template <typename Number>
void store(double value, std::byte* at) {
  constexpr auto low = static_cast<double>(std::numeric_limits<Number>::lowest());
  constexpr auto high = static_cast<double>(std::numeric_limits<Number>::max());
  Number number{};
  if constexpr (std::numeric_limits<Number>::is_integer) {
    if (!std::isnan(value))
      number = static_cast<Number>(std::clamp(std::nearbyint(value), low, high));
  } else {
    number = static_cast<Number>(std::isfinite(value) ? std::clamp(value, low, high) : value);
  }
  std::memcpy(at, &number, sizeof number);
}

}  // namespace

std::size_t size_of(NumberType type) {
  return facts.at(static_cast<std::size_t>(type)).size;
}
bool is_integer(NumberType type) {
  return type != NumberType::float32 && type != NumberType::float64;
}
bool is_wide_integer(NumberType type) {
  return type == NumberType::int64 || type == NumberType::uint64;
}
const char* name_of(NumberType type) {
  return facts.at(static_cast<std::size_t>(type)).name;
}

void store_rounded(double value, NumberType type, std::byte* at) {
  with_type(type, [&]<typename Number>(Number) { store<Number>(value, at); });
}

}  // namespace winnow
