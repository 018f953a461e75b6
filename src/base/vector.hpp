// Points and vectors of three doubles.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>

namespace winnow {

using Point = std::array<double, 3>;
using Triangle = std::array<Point, 3>;

inline Point operator-(const Point& a, const Point& b) {
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}
inline Point operator+(const Point& a, const Point& b) {
  return {a[0] + b[0], a[1] + b[1], a[2] + b[2]};
}
inline Point operator*(double scale, const Point& p) {
  return {scale * p[0], scale * p[1], scale * p[2]};
}
inline double dot(const Point& a, const Point& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}
inline Point cross(const Point& a, const Point& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
inline double length(const Point& p) {
  return std::sqrt(dot(p, p));
}
// As long as 1; zero stays zero.
inline Point unit(const Point& p) {
  const double size = length(p);
  return size > 0 ? (1 / size) * p : p;
}
inline bool finite(const Point& p) {
  return std::isfinite(p[0]) && std::isfinite(p[1]) && std::isfinite(p[2]);
}

// The nearest float. GCC 12 takes two such conversions and back, side by side, for none at all; the
// empty instruction keeps them apart.
inline double nearest_float(double value) {
  auto single = static_cast<float>(value);
  asm("" : "+x"(single));
  return static_cast<double>(single);
}

// As long as twice the area.
inline Point doubled_area(const Triangle& t) {
  return cross(t[1] - t[0], t[2] - t[0]);
}

}  // namespace winnow
