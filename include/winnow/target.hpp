// How fine a result shall be.
#pragma once

#include <winnow/distance.hpp>

#include <cstdint>
#include <optional>

namespace winnow {

// One of five kinds: a count of faces, a part of the input's, an error, or the size or the number
// of the cells that vertices are clustered in.
class Target {
 public:
  enum class Kind : std::uint8_t { none, faces, ratio, error, cell, grid };

  constexpr Target() = default;  // none: not yet said

  // So many faces; >= 4. Exact where the result is refined, else about.
  static constexpr Target faces(std::uint64_t count) { return {Kind::faces, count, {}}; }
  // The same as a part of the input's faces; in (0, 1].
  static constexpr Target ratio(double part) { return {Kind::ratio, 0, part}; }
  // As few faces as there can be with this error; > 0, and below the diagonal where it is a part of
  // that. It bounds the two-sided RMS distance. No point of a boundary is farther than 1.5 times
  // the error from the other boundary, both ways. Only with Refine::quadric.
  static constexpr Target error(Distance distance) { return {Kind::error, 0, distance}; }
  // The edge of a cubic grid cell, in the units of the model; > 0.
  static constexpr Target cell(double length) { return {Kind::cell, 0, length}; }
  // Cells along the longest side of the bounding box; 1 to 2^21.
  static constexpr Target grid(std::uint64_t cells) { return {Kind::grid, cells, {}}; }

  [[nodiscard]] constexpr Kind kind() const { return kind_; }
  [[nodiscard]] constexpr bool of_count() const {
    return kind_ == Kind::faces || kind_ == Kind::ratio;
  }
  [[nodiscard]] constexpr bool of_cells() const {
    return kind_ == Kind::cell || kind_ == Kind::grid;
  }
  // Each is what it was made of, and nothing for a target of another kind.
  [[nodiscard]] constexpr std::optional<std::uint64_t> faces() const {
    return if_of(Kind::faces, count_);
  }
  [[nodiscard]] constexpr std::optional<double> ratio() const {
    return if_of(Kind::ratio, distance_.value);
  }
  [[nodiscard]] constexpr std::optional<Distance> error() const {
    return if_of(Kind::error, distance_);
  }
  [[nodiscard]] constexpr std::optional<double> cell() const {
    return if_of(Kind::cell, distance_.value);
  }
  [[nodiscard]] constexpr std::optional<std::uint64_t> grid() const {
    return if_of(Kind::grid, count_);
  }

  friend constexpr bool operator==(const Target&, const Target&) = default;

 private:
  constexpr Target(Kind kind, std::uint64_t count, Distance distance)
      : kind_(kind), count_(count), distance_(distance) {}

  template <typename Value>
  [[nodiscard]] constexpr std::optional<Value> if_of(Kind kind, Value value) const {
    return kind_ == kind ? std::optional(value) : std::nullopt;
  }

  Kind kind_ = Kind::none;
  std::uint64_t count_ = 0;  // of faces or cells
  Distance distance_;        // or a ratio, or a cell's edge
};

}  // namespace winnow
