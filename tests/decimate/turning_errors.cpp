// One face that turns by a known angle about the side across from the vertex.
#include "decimate/importance_cost.hpp"

#include <cmath>
#include <vector>

#include <catch2/catch.hpp>

namespace winnow {

namespace {

// The face between (-1/2, 1, 0) and (1/2, 1, 0) has height 1 and area 1/2 before; its vertex goes to `to`.
double error_of_going(const Point& to) {
  return turning_error(std::vector<Point>{to, {-0.5, 1, 0}, {0.5, 1, 0}}, false, 0);
}

}  // namespace

TEST_CASE("a face that stays in its plane costs nothing") {
  CHECK(error_of_going({0, 0.5, 0}) == 0);
  CHECK(error_of_going({2, -1, 0}) == 0);
}

TEST_CASE("a face that turns costs its mean area times 1 less the cosine") {
  CHECK(error_of_going({0, 1, 1}) == Approx(0.5));
  CHECK(error_of_going({0, 0.5, std::sqrt(0.75)}) == Approx(0.25));
  CHECK(error_of_going({0, 1, 2}) == Approx(0.75));
  CHECK(error_of_going({0, 2, 0}) == Approx(1));
}

TEST_CASE("faces at the collapsed edge cost nothing") {
  const std::vector<Point> corner{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  // Of three faces one is left, x + y + z = 1 in place of x = 0: twice the areas are 1 and the root of 3.
  const double cosine = 1 / std::sqrt(3.0);
  CHECK(turning_error(corner, true, 0) == Approx((1 + std::sqrt(3.0)) / 4 * (1 - cosine)));
}

}  // namespace winnow
