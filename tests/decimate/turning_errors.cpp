// One face that turns by a known angle about the side across from the vertex.
#include "decimate/importance_cost.hpp"

#include <cmath>
#include <numbers>
#include <vector>

#include <catch2/catch.hpp>

namespace winnow {

namespace {

// The face between (-1/2, 1, 0) and (1/2, 1, 0) has height 1 and area 1/2 before; its vertex goes
// to `to`.
double error_of_going(const Point& to) {
  const std::vector<Point> seen{to, {-0.5, 1, 0}, {0.5, 1, 0}};
  return turning_error({seen, false}, 0);
}

}  // namespace

TEST_CASE("a face that stays in its plane costs nothing") {
  CHECK(error_of_going({0, 0.5, 0}) == 0);
  CHECK(error_of_going({2, -1, 0}) == 0);
}

TEST_CASE(
    "a face that turns costs its area times the angle, to within six percent up to 45 degrees") {
  for (const double degrees : {1e-6, 0.1, 5.0, 20.0, 45.0}) {
    CAPTURE(degrees);
    const double angle = degrees * std::numbers::pi / 180;
    const double error = error_of_going({0, 1 - std::cos(angle), std::sin(angle)});
    CHECK(error >= 0.5 * angle * (1 - 1e-9));
    CHECK(error <= 0.5 * angle * 1.06);
  }
}

TEST_CASE("the area is the mean of that before and after") {
  // At a right angle, half as high and twice as high.
  const double right_angle = 2;
  CHECK(error_of_going({0, 1, 1}) == Approx(0.5 * right_angle));
  CHECK(error_of_going({0, 1, 0.5}) == Approx(0.375 * right_angle));
  CHECK(error_of_going({0, 1, 2}) == Approx(0.75 * right_angle));
}

TEST_CASE("the farther a face turns, the more it costs") {
  double last = 0;
  for (const double degrees : {1.0, 30.0, 60.0, 90.0, 120.0, 150.0, 179.0}) {
    const double angle = degrees * std::numbers::pi / 180;
    const double error = error_of_going({0, 1 - std::cos(angle), std::sin(angle)});
    CHECK(error > last);
    last = error;
  }
}

TEST_CASE("faces at the collapsed edge cost nothing") {
  const std::vector<Point> corner{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  // Of three faces one is left, x + y + z = 1 in place of x = 0: twice the areas are 1 and the root
  // of 3.
  const double angle = 2 * std::tan(std::acos(1 / std::sqrt(3.0)) / 2);
  CHECK(turning_error({corner, true}, 0) == Approx((1 + std::sqrt(3.0)) / 4 * angle));
}

}  // namespace winnow
