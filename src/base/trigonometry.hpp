// Angles by operations that round the same everywhere: those of the system's library may not.
#pragma once

namespace winnow {

inline constexpr double pi = 3.14159265358979323846;

// Of an angle between 0 and pi, to within 10^-14.
double cosine(double angle);

}  // namespace winnow
