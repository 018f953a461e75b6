// Angles by operations that round the same everywhere: those of the system's library may not.
#pragma once

namespace winnow {

inline constexpr double pi = 3.14159265358979323846;

// Of an angle between 0 and pi, to within 10^-14.
double cosine(double angle);

// The angle of the point (x, y) seen from the origin: above -pi, at most pi; 0 for the origin. To within
// 10^-14.
double angle_of(double y, double x);

}  // namespace winnow
