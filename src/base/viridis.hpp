// Numbers as colours.
#pragma once

#include <array>
#include <cstdint>

namespace winnow {

using Color = std::array<std::uint8_t, 3>;  // red, green, blue

// Viridis: from dark violet for nothing over green to yellow for `most` and more. Equal steps of
// the value look equal.
Color viridis(double value, double most);

// The value of the last colour, for distances of this root mean square; 0 where they are nothing
// but rounding.
double last_color_at(double rms, double diagonal);

}  // namespace winnow
