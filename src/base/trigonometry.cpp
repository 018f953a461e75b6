#include "base/trigonometry.hpp"

namespace winnow {

double cosine(double angle) {
  // cos(a) = 1 - 2 sin(a/2)^2, twice, so that the series is asked for an eighth of a turn at the
  // most.
  const double x = angle / 4;
  const double xx = x * x;
  double series = 1;
  for (int n = 21; n > 1; n -= 2) series = 1 - xx / (n * (n - 1)) * series;
  const double half_cosine = 1 - 2 * (x * series) * (x * series);
  return 2 * half_cosine * half_cosine - 1;
}

}  // namespace winnow
