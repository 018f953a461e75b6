#include "base/trigonometry.hpp"

#include <cmath>

namespace winnow {

double cosine(double angle) {
  // cos(a) = 1 - 2 sin(a/2)^2, twice, so that the series is asked for an eighth of a turn at the most.
  const double x = angle / 4;
  const double xx = x * x;
  double series = 1;
  for (int n = 21; n > 1; n -= 2) series = 1 - xx / (n * (n - 1)) * series;
  const double half_cosine = 1 - 2 * (x * series) * (x * series);
  return 2 * half_cosine * half_cosine - 1;
}

namespace {

// Of a number from 0 to 1.
double arctangent(double t) {
  // atan(t) = 2 atan(t / (1 + sqrt(1 + t^2))), three times: then t is below 0.1 and the series is short.
  for (int i = 0; i < 3; ++i) t /= 1 + std::sqrt(1 + t * t);
  const double tt = t * t;
  double series = 0;
  for (int n = 19; n > 0; n -= 2) series = 1.0 / n - tt * series;
  return 8 * t * series;
}

}  // namespace

double angle_of(double y, double x) {
  const double across = std::abs(x);
  const double up = std::abs(y);
  if (across == 0 && up == 0) return 0;
  double angle = up <= across ? arctangent(up / across) : pi / 2 - arctangent(across / up);
  if (x < 0) angle = pi - angle;
  return y < 0 ? -angle : angle;
}

}  // namespace winnow
