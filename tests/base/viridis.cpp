// Equal steps of a value look equal.
#include "base/viridis.hpp"

#include <cmath>

#include <catch2/catch.hpp>

namespace winnow::test {

namespace {

// Of CIELAB: from 0, black, to 100, white.
double lightness(const Color& color) {
  const auto linear = [](std::uint8_t channel) {
    const double c = channel / 255.0;
    return c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4);
  };
  const double y =
      0.2126 * linear(color[0]) + 0.7152 * linear(color[1]) + 0.0722 * linear(color[2]);
  return y > 0.008856 ? 116 * std::cbrt(y) - 16 : 903.3 * y;
}

}  // namespace

TEST_CASE("the colours of distances grow lighter in even steps") {
  const double dark = lightness(viridis(0, 1));
  const double light = lightness(viridis(1, 1));
  CHECK(light - dark > 70);
  for (int i = 0; i <= 100; ++i)
    CHECK(lightness(viridis(i, 100)) == Approx(dark + (light - dark) * i / 100).margin(2.5));
  CHECK(viridis(7, 1) == viridis(1, 1));
  CHECK(viridis(0, 0) == viridis(0, 1));
}

TEST_CASE("distances that are nothing but rounding have no colours of their own") {
  const double rounding = 1e-16;
  for (const double diagonal : {1e-3, 1.0, 1e6}) {
    CHECK(last_color_at(rounding * diagonal, diagonal) == 0);
    CHECK(last_color_at(1e-9 * diagonal, diagonal) == Approx(3e-9 * diagonal));
  }
  CHECK(viridis(rounding, last_color_at(rounding, 1)) == viridis(0, 1));
  CHECK(last_color_at(0, 0) == 0);
}

}  // namespace winnow::test
