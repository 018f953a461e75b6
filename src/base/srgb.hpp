// The transfer function of sRGB (IEC 61966-2-1), by operations that round the same everywhere.
#pragma once

namespace winnow {

// Light, in proportion, of a colour component; 1 stays 1. Continued below 0 as an odd function, and
// beyond 1. To within a few units in the last place.
double light_of_component(double component);

// The other way round.
double component_of_light(double light);

}  // namespace winnow
