// What is to know of the types of numbers.
#pragma once

#include <winnow/number_type.hpp>

#include <cstddef>
#include <cstdint>
#include <stdexcept>

namespace winnow {

std::size_t size_of(NumberType type);
bool is_integer(NumberType type);
bool is_wide_integer(NumberType type);  // of 64 bits
const char* name_of(NumberType type);   // "uchar", "float": as PLY calls it

// Calls function(Number{}), where Number is the C++ type. Not for whole numbers of 64 bits, which
// vertices have no numbers of.
template <typename Function>
decltype(auto) with_type(NumberType type, const Function& function) {
  switch (type) {
    case NumberType::int8:
      return function(std::int8_t{});
    case NumberType::uint8:
      return function(std::uint8_t{});
    case NumberType::int16:
      return function(std::int16_t{});
    case NumberType::uint16:
      return function(std::uint16_t{});
    case NumberType::int32:
      return function(std::int32_t{});
    case NumberType::uint32:
      return function(std::uint32_t{});
    case NumberType::float32:
      return function(float{});
    case NumberType::float64:
      return function(double{});
    case NumberType::int64:
    case NumberType::uint64:
      break;
  }
  throw std::logic_error("whole numbers of 64 bits are not carried");
}

// Writes the number of the type that is nearest to `value`, and so the lowest or the highest one
// where that is beyond. Of what is not finite a real type keeps what it is; no number is 0 as a
// whole one.
void store_rounded(double value, NumberType type, std::byte* at);

}  // namespace winnow
