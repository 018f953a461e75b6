// Numbers as colours.
#pragma once

#include <array>
#include <cstdint>

namespace winnow {

using Color = std::array<std::uint8_t, 3>;  // red, green, blue

// Blue for nothing over green and yellow to red for `most` and more.
Color heat_color(double value, double most);

}  // namespace winnow
