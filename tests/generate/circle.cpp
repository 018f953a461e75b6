// Our own sine and cosine, against the system's.
#include "generate/circle.hpp"

#include <algorithm>
#include <cmath>

#include <catch2/catch.hpp>

namespace winnow {

TEST_CASE("points on the circle are within 3e-16") {
  long double worst = 0;
  constexpr int parts = 100'003;
  for (int k = 0; k <= parts; ++k) {
    const double turn = static_cast<double>(k) / parts;
    const auto [cosine, sine] = on_circle(turn);
    const long double angle = static_cast<long double>(turn) * 6.283185307179586476925286766559L;
    worst = std::max({worst, std::abs(cosine - std::cos(angle)), std::abs(sine - std::sin(angle))});
  }
  CAPTURE(static_cast<double>(worst));
  CHECK(worst < 3e-16L);
}

TEST_CASE("quarters of a turn are exact") {
  CHECK(on_circle(0).cosine == 1);
  CHECK(on_circle(0).sine == 0);
  CHECK(on_circle(0.25).cosine == 0);
  CHECK(on_circle(0.25).sine == 1);
  CHECK(on_circle(0.5).cosine == -1);
  CHECK(on_circle(0.5).sine == 0);
  CHECK(on_circle(0.75).cosine == 0);
  CHECK(on_circle(0.75).sine == -1);
  CHECK(on_circle(1).cosine == 1);
  CHECK(on_circle(1).sine == 0);
}

}  // namespace winnow
