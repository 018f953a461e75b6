// Triangles by their corners' positions: what every reader gives and every later station takes.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace winnow {

enum class FaceStatus : std::uint8_t {
  good,
  degenerate,    // fewer than three corners; repeated positions are found later
  out_of_range,  // an index of no vertex
  cropped        // a corner outside of the box that is asked for
};

// A slice of the input, small enough to stay in a core's nearest caches. Arrays side by side, so
// that loops over them vectorise.
struct FaceBatch {
  static constexpr std::size_t capacity = 128;

  std::size_t count = 0;
  std::uint64_t first = 0;  // number of the first face, from 0 over the whole input
  bool all_good = true;     // no status but good
  bool single =
      false;  // positions are in `single_position`, as the file has them; else in `position`
  template <typename Real>
  using Positions =
      std::array<std::array<std::array<Real, capacity>, 3>, 3>;  // [corner][axis][face]
  alignas(64) Positions<double> position;
  alignas(64) Positions<float> single_position;
  std::array<FaceStatus, capacity> status;
  // The numbers of the corners' vertices, [corner][face], where the format has vertices; good for
  // as long as the batch is handed on.
  std::array<const std::uint32_t*, 3> index{};
  std::uint64_t first_vertex = 0;  // what vertex() counts from: vertices of inputs before this one
  // The low 32 bits of the faces' numbers, where the reader changed their order; else null, and
  // they count from `first`. Valid as long as `index`.
  const std::uint32_t* numbers = nullptr;
  // Of the attributes that the reader carries: [attribute][corner][face]. Empty where it carries
  // none.
  std::vector<double> attributes;

  [[nodiscard]] std::array<double, 3> corner(std::size_t corner, std::size_t face) const {
    std::array<double, 3> xyz{};
    for (std::size_t axis = 0; axis < 3; ++axis) {
      xyz[axis] =
          single ? double{single_position[corner][axis][face]} : position[corner][axis][face];
    }
    return xyz;
  }

  // The low 32 bits of a face's number over the whole input.
  [[nodiscard]] std::uint32_t number(std::size_t face) const {
    return numbers != nullptr ? numbers[face] : static_cast<std::uint32_t>(first + face);
  }

  // A corner's vertex over the whole input. Without vertices each corner is one.
  [[nodiscard]] std::uint64_t vertex(std::size_t corner, std::size_t face) const {
    return first_vertex + (index[0] != nullptr ? index[corner][face] : 3 * (first + face) + corner);
  }

  [[nodiscard]] double attribute(std::size_t number, std::size_t corner, std::size_t face) const {
    return attributes[(3 * number + corner) * capacity + face];
  }

  [[nodiscard]] bool repeats_a_corner(std::size_t face) const {
    const std::array<double, 3> a = corner(0, face);
    const std::array<double, 3> b = corner(1, face);
    const std::array<double, 3> c = corner(2, face);
    return a == b || a == c || b == c;
  }
};

// Positions without their faces.
struct PositionView {
  std::array<const double*, 3> axis{};  // at most FaceBatch::capacity of each
  std::size_t count = 0;
  std::uint64_t first =
      0;                // number of the first vertex; where there are only faces, of the first face
  unsigned corner = 0;  // where there are only faces, which of their corners; else 0
  bool only_faces = false;
  std::uint64_t first_vertex = 0;  // what vertex() counts from, as in a FaceBatch

  // A position's vertex over the whole input, as FaceBatch::vertex() numbers them.
  [[nodiscard]] std::uint64_t vertex(std::size_t i) const {
    return first_vertex + (only_faces ? 3 * (first + i) + corner : first + i);
  }
};

}  // namespace winnow
