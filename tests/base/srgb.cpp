// Colours go to light and come back.
#include "base/srgb.hpp"

#include <cmath>

#include <catch2/catch.hpp>

namespace winnow {

TEST_CASE("every colour of 8 and 16 bits comes back from light") {
  for (const int full : {255, 65535}) {
    int wrong = 0;
    double last = -1;
    for (int i = 0; i <= full; ++i) {
      const double light = light_of_component(i / double(full));
      wrong += !(light > last) || std::abs(component_of_light(light) * full - i) > 1e-9;
      last = light;
    }
    CHECK(wrong == 0);
    CHECK(last == Approx(1).epsilon(1e-15));
  }
}

TEST_CASE("light is what the standard says") {
  CHECK(light_of_component(0) == 0);
  CHECK(light_of_component(0.04) == Approx(0.04 / 12.92).epsilon(1e-15));
  CHECK(light_of_component(0.5) == Approx(0.21404114048223255).epsilon(1e-14));
  CHECK(light_of_component(0.9) == Approx(std::pow(0.955 / 1.055, 2.4)).epsilon(1e-14));
  CHECK(component_of_light(0.21404114048223255) == Approx(0.5).epsilon(1e-14));
  CHECK(light_of_component(-0.5) == -light_of_component(0.5));
}

TEST_CASE("colours far beyond white keep their size") {
  for (const double component : {255.0, 1e5, 1e30, 1e100})
    CHECK(component_of_light(light_of_component(component)) == Approx(component).epsilon(1e-13));
}

}  // namespace winnow
