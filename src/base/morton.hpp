// Cell keys: 63-bit Morton codes, 21 bits an axis.
#pragma once

#include <array>
#include <cstdint>

namespace winnow {

using CellKey = std::uint64_t;  // bits 0, 3, 6, ... are x; 1, 4, 7, ... y; 2, 5, 8, ... z
inline constexpr unsigned axis_bits = 21;
inline constexpr std::uint32_t axis_cells = 1U << axis_bits;

// Puts the low 21 bits of `v` at every third place.
constexpr std::uint64_t spread_bits(std::uint64_t v) {
  v &= 0x1fffff;
  v = (v | v << 32) & 0x001f00000000ffff;
  v = (v | v << 16) & 0x001f0000ff0000ff;
  v = (v | v << 8) & 0x100f00f00f00f00f;
  v = (v | v << 4) & 0x10c30c30c30c30c3;
  v = (v | v << 2) & 0x1249249249249249;
  return v;
}

constexpr std::uint32_t gather_bits(std::uint64_t v) {
  v &= 0x1249249249249249;
  v = (v | v >> 2) & 0x10c30c30c30c30c3;
  v = (v | v >> 4) & 0x100f00f00f00f00f;
  v = (v | v >> 8) & 0x001f0000ff0000ff;
  v = (v | v >> 16) & 0x001f00000000ffff;
  v = (v | v >> 32) & 0x1fffff;
  return static_cast<std::uint32_t>(v);
}

constexpr CellKey morton_key(std::uint32_t x, std::uint32_t y, std::uint32_t z) {
  return spread_bits(x) | spread_bits(y) << 1 | spread_bits(z) << 2;
}

constexpr std::array<std::uint32_t, 3> morton_cell(CellKey key) {
  return {gather_bits(key), gather_bits(key >> 1), gather_bits(key >> 2)};
}

// The same three coordinates side by side: cheaper to make, good enough to compare and to hash.
using PackedCell = std::uint64_t;

constexpr PackedCell pack_cell(std::uint32_t x, std::uint32_t y, std::uint32_t z) {
  return std::uint64_t{x} | std::uint64_t{y} << axis_bits | std::uint64_t{z} << (2 * axis_bits);
}

constexpr CellKey morton_key(PackedCell cell) {
  return spread_bits(cell) | spread_bits(cell >> axis_bits) << 1 |
         spread_bits(cell >> (2 * axis_bits)) << 2;
}

}  // namespace winnow
