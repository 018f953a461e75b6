#include "base/viridis.hpp"

#include <algorithm>
#include <cstddef>

namespace winnow {

Color viridis(double value, double most) {
  // Every 15th of the 256 colours of van der Walt and Smith (2015).
  constexpr std::array<Color, 18> stops{{{68, 1, 84},
                                         {72, 23, 105},
                                         {71, 42, 122},
                                         {67, 61, 132},
                                         {61, 78, 138},
                                         {53, 94, 141},
                                         {46, 109, 142},
                                         {41, 123, 142},
                                         {35, 137, 142},
                                         {31, 151, 139},
                                         {33, 165, 133},
                                         {46, 179, 124},
                                         {70, 192, 111},
                                         {101, 203, 94},
                                         {137, 213, 72},
                                         {176, 221, 47},
                                         {216, 226, 25},
                                         {253, 231, 37}}};
  const double at = most > 0 ? std::clamp(value / most, 0.0, 1.0) * (stops.size() - 1) : 0;
  const auto below = std::min(static_cast<std::size_t>(at), stops.size() - 2);
  const double part = at - static_cast<double>(below);
  Color color{};
  for (std::size_t c = 0; c < 3; ++c) {
    const double low = stops[below][c];
    color[c] = static_cast<std::uint8_t>(low + part * (stops[below + 1][c] - low) + 0.5);
  }
  return color;
}

double last_color_at(double rms, double diagonal) {
  return rms > 1e-12 * diagonal ? 3 * rms : 0;
}

}  // namespace winnow
