// The types of single numbers in mesh files.
#pragma once

#include <cstddef>
#include <cstdint>

namespace winnow {

enum class ScalarType : std::uint8_t {
  int8,
  uint8,
  int16,
  uint16,
  int32,
  uint32,
  float32,
  float64
};

std::size_t size_of(ScalarType type);
bool is_integer(ScalarType type);
const char* name_of(ScalarType type);  // "uchar", "float": as PLY calls it

// Calls function(Number{}), where Number is the C++ type.
template <typename Function>
decltype(auto) with_type(ScalarType type, const Function& function) {
  switch (type) {
    case ScalarType::int8:
      return function(std::int8_t{});
    case ScalarType::uint8:
      return function(std::uint8_t{});
    case ScalarType::int16:
      return function(std::int16_t{});
    case ScalarType::uint16:
      return function(std::uint16_t{});
    case ScalarType::int32:
      return function(std::int32_t{});
    case ScalarType::uint32:
      return function(std::uint32_t{});
    case ScalarType::float32:
      return function(float{});
    default:
      return function(double{});
  }
}

// Writes the number of the type that is nearest to `value`, and so the lowest or the highest one
// where that is beyond. Of what is not finite a real type keeps what it is; no number is 0 as a
// whole one.
void store_rounded(double value, ScalarType type, std::byte* at);

}  // namespace winnow
