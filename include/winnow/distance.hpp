// A length that is given in one of two ways.
#pragma once

namespace winnow {

// In model units, or as a part of the diagonal of the input's box.
struct Distance {
  double value = 0;
  bool relative = false;  // `value` is a part of the diagonal: 0.001 is 0.1 %

  constexpr Distance() = default;
  constexpr Distance(double length) : value(length) {}  // so that `options.weld = 0.5` is one
  static constexpr Distance of_diagonal(double part) {
    Distance distance(part);
    distance.relative = true;
    return distance;
  }
  // In model units.
  [[nodiscard]] constexpr double length(double diagonal) const {
    return relative ? value * diagonal : value;
  }
  friend constexpr bool operator==(const Distance&, const Distance&) = default;
};

}  // namespace winnow
