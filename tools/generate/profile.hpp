// The rough shape of the scanned sculpture: a bust, as rings around an upright axis.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace winnow {

// One ring of the rough shape. Its radius at angle a is
// radius * (1 + cosine[0] cos a + sine[0] sin a + cosine[1] cos 2a + ...); the face looks towards a
// = 0.
struct Ring {
  double radius, height;
  double out, up;  // the direction, outwards and upwards, in which the relief raises the surface
  std::array<double, 3> cosine;
  std::array<double, 2> sine;
};

class Profile {
 public:
  explicit Profile(std::uint32_t seed);

  // The ring at a part of the way along the profile, from the crown (0) to the middle of the base
  // (1): both have radius 0.
  [[nodiscard]] Ring ring(double along) const;

  // Columns for a row at which edges along and across the rings are about equally long, on most of
  // the area.
  [[nodiscard]] double proportion() const { return proportion_; }

 private:
  static constexpr std::size_t steps = 4096;

  [[nodiscard]] Ring at(double knot) const;
  void measure();

  std::vector<Ring> controls_;  // of a uniform cubic B-spline; out and up are not used
  std::array<double, steps + 1>
      knots_{};  // where each of `steps` equal lengths along the profile begins
  double proportion_ = 1;
};

}  // namespace winnow
