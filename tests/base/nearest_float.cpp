// Positions are rounded to floats on every axis, whatever the compiler makes of three of them at
// once.
#include "base/vector.hpp"
#include "support/random.hpp"

#include <cstring>

#include <catch2/catch.hpp>

namespace winnow {

TEST_CASE("a position is rounded to floats on every axis") {
  test::Random random(20);
  for (int i = 0; i < 1000; ++i) {
    Point p{random.real(-5e6, 5e6), random.real(-5e6, 5e6), random.real(-5e6, 5e6)};
    std::array<volatile float, 3> right{};
    for (std::size_t axis = 0; axis < 3; ++axis) right[axis] = static_cast<float>(p[axis]);
    for (double& x : p) x = nearest_float(x);
    for (std::size_t axis = 0; axis < 3; ++axis) CHECK(p[axis] == static_cast<double>(right[axis]));
  }
}

}  // namespace winnow
