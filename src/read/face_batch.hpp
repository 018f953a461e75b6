// Triangles by their corners' positions: what every reader gives and every later station takes.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

namespace winnow {

enum class FaceStatus : std::uint8_t {
  good,
  degenerate,    // fewer than three corners; repeated positions are found later
  out_of_range,  // an index of no vertex
};

// A slice of the input, small enough to stay in a core's nearest caches. Arrays side by side, so that
// loops over them vectorise.
struct FaceBatch {
  static constexpr std::size_t capacity = 512;

  std::size_t count = 0;
  std::uint64_t first = 0;     // number of the first face, from 0 over the whole input
  bool all_good = true;        // no status but good
  alignas(64) std::array<std::array<std::array<double, capacity>, 3>, 3> position;  // [corner][axis][face]
  std::array<FaceStatus, capacity> status;
};

// Positions without their faces.
struct PositionView {
  std::array<const double*, 3> axis{};
  std::size_t count = 0;
  std::uint64_t first = 0;  // number of the first vertex; where there are only faces, of the first face
  unsigned corner = 0;      // where there are only faces, which of their corners; else 0
};

}  // namespace winnow
