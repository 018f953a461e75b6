// Positions from records to columns, for the layouts that nearly every file has: x, y and z side by
// side.
#pragma once

#include "read/face_batch.hpp"

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>

namespace winnow {

template <typename Given>
void gather_doubles(const std::byte* base, std::size_t stride, const std::uint32_t* index,
                    std::size_t count, std::array<std::array<Given, FaceBatch::capacity>, 3>& out) {
  for (std::size_t i = 0; i < count; ++i) {
    std::array<double, 3> xyz;
    std::memcpy(xyz.data(), base + std::size_t{index[i]} * stride, sizeof xyz);
    for (std::size_t axis = 0; axis < 3; ++axis) out[axis][i] = static_cast<Given>(xyz[axis]);
  }
}

using FourFloats = float __attribute__((vector_size(16)));

inline FourFloats load_three(const std::byte* at) {
  using TwoDoubles = double __attribute__((vector_size(16)));
  double two = 0;
  float third = 0;
  std::memcpy(&two, at, sizeof two);
  std::memcpy(&third, at + sizeof two, sizeof third);
  return __builtin_shufflevector(std::bit_cast<FourFloats>(TwoDoubles{two, 0}),
                                 FourFloats{third, 0, 0, 0}, 0, 1, 4, 5);
}

// Four records are turned into parts of three columns at a time.
inline void gather_floats(const std::byte* base, std::size_t stride, const std::uint32_t* index,
                          std::size_t count,
                          std::array<std::array<float, FaceBatch::capacity>, 3>& out) {
  const auto record = [&](std::size_t i) {
    return load_three(base + std::size_t{index[i]} * stride);
  };
  std::size_t i = 0;
  for (; i + 4 <= count; i += 4) {
    const FourFloats a = record(i), b = record(i + 1), c = record(i + 2), d = record(i + 3);
    const FourFloats ab = __builtin_shufflevector(a, b, 0, 4, 1, 5);
    const FourFloats cd = __builtin_shufflevector(c, d, 0, 4, 1, 5);
    const FourFloats ab_z = __builtin_shufflevector(a, b, 2, 6, 3, 7);
    const FourFloats cd_z = __builtin_shufflevector(c, d, 2, 6, 3, 7);
    const FourFloats x = __builtin_shufflevector(ab, cd, 0, 1, 4, 5);
    const FourFloats y = __builtin_shufflevector(ab, cd, 2, 3, 6, 7);
    const FourFloats z = __builtin_shufflevector(ab_z, cd_z, 0, 1, 4, 5);
    std::memcpy(&out[0][i], &x, sizeof x);
    std::memcpy(&out[1][i], &y, sizeof y);
    std::memcpy(&out[2][i], &z, sizeof z);
  }
  for (; i < count; ++i) {
    const FourFloats xyz = record(i);
    for (std::size_t axis = 0; axis < 3; ++axis) out[axis][i] = xyz[axis];
  }
}

}  // namespace winnow
