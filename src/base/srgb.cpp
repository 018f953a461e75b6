#include "base/srgb.hpp"

#include <cmath>

namespace winnow {

namespace {

// The root of x > 0 by Newton's method, which comes down to it from above.
template <int degree>
double root_of(double x) {
  int exponent = 0;
  std::frexp(x, &exponent);  // x is below 2^exponent
  double root = std::ldexp(1, exponent / degree + 1);
  for (;;) {
    double power = root;
    for (int i = 2; i < degree; ++i) power *= root;
    const double next = ((degree - 1) * root + x / power) / degree;
    if (!(next < root)) return root;
    root = next;
  }
}

}  // namespace

double light_of_component(double component) {
  const double size = std::abs(component);
  if (size <= 0.04045) return component / 12.92;
  // y^2.4 = y^2 (y^2)^(1/5)
  const double y = (size + 0.055) / 1.055;
  const double light = y * y * root_of<5>(y * y);
  return component < 0 ? -light : light;
}

double component_of_light(double light) {
  const double size = std::abs(light);
  if (size <= 0.0031308) return light * 12.92;
  // x^(1/2.4) = x^(5/12): the third root of the fourth root of x, to the fifth power.
  const double root = root_of<3>(std::sqrt(std::sqrt(size)));
  const double square = root * root;
  const double component = 1.055 * (square * square * root) - 0.055;
  return light < 0 ? -component : component;
}

}  // namespace winnow
