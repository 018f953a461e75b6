// One number of a binary PLY record.
#pragma once

#include "read/ply/header.hpp"

#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <type_traits>

namespace winnow {

template <typename T>
T load(const std::byte* at, bool swapped) {
  using Bits = std::conditional_t<
      sizeof(T) == 1, std::uint8_t,
      std::conditional_t<sizeof(T) == 2, std::uint16_t,
                         std::conditional_t<sizeof(T) == 4, std::uint32_t, std::uint64_t>>>;
  Bits bits;
  std::memcpy(&bits, at, sizeof bits);
  if (swapped) {
    if constexpr (sizeof(T) == 2) bits = __builtin_bswap16(bits);
    if constexpr (sizeof(T) == 4) bits = __builtin_bswap32(bits);
    if constexpr (sizeof(T) == 8) bits = __builtin_bswap64(bits);
  }
  return std::bit_cast<T>(bits);
}

inline double load_real(const std::byte* at, PlyType type, bool swapped) {
  return with_type(type, [&]<typename Number>(Number) {
    return static_cast<double>(load<Number>(at, swapped));
  });
}

// Integers of any of the format's types; a real number is cut to its whole part, as other readers
// do.
inline std::int64_t load_integer(const std::byte* at, PlyType type, bool swapped) {
  if (type == PlyType::uint32) return load<std::uint32_t>(at, swapped);
  const double value = load_real(at, type, swapped);
  // Not a number, or beyond any index: no vertex has it.
  if (!(value > -9.0e15 && value < 9.0e15)) return -1;
  return static_cast<std::int64_t>(value);
}

}  // namespace winnow
