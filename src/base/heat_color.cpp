#include "base/heat_color.hpp"

#include <algorithm>

namespace winnow {

Color heat_color(double value, double most) {
  constexpr std::array<std::array<double, 3>, 5> stops{
      {{48, 64, 200}, {40, 170, 220}, {80, 200, 90}, {240, 220, 60}, {210, 40, 40}}};
  const double at = most > 0 ? std::clamp(value / most, 0.0, 1.0) * (stops.size() - 1) : 0;
  const auto below = std::min(static_cast<std::size_t>(at), stops.size() - 2);
  const double part = at - static_cast<double>(below);
  Color color{};
  for (std::size_t c = 0; c < 3; ++c) {
    color[c] =
        static_cast<std::uint8_t>(stops[below][c] + part * (stops[below + 1][c] - stops[below][c]) + 0.5);
  }
  return color;
}

}  // namespace winnow
