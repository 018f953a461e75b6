// A face by the numbers of its vertices.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>

namespace winnow {

using FaceVertices = std::array<std::uint32_t, 3>;

inline constexpr std::uint32_t no_number = UINT32_MAX;

inline bool has(const FaceVertices& face, std::uint32_t v) {
  return face[0] == v || face[1] == v || face[2] == v;
}

// The same face with its lowest number first.
inline FaceVertices lowest_first(FaceVertices face) {
  if (face[0] < face[1] && face[0] < face[2]) return face;  // as most are
  std::rotate(face.begin(), std::min_element(face.begin(), face.end()), face.end());
  return face;
}

}  // namespace winnow
