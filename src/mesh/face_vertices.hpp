// A face by the numbers of its vertices.
#pragma once

#include <array>
#include <cstdint>

namespace winnow {

using FaceVertices = std::array<std::uint32_t, 3>;

inline constexpr std::uint32_t no_number = UINT32_MAX;

inline bool has(const FaceVertices& face, std::uint32_t v) {
  return face[0] == v || face[1] == v || face[2] == v;
}

// The same face with its lowest number first.
inline FaceVertices lowest_first(const FaceVertices& face) {
  const auto [a, b, c] = face;
  if (a <= b && a <= c) return face;  // as most are
  if (b <= c) return {b, c, a};
  return {c, a, b};
}

}  // namespace winnow
