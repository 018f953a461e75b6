// How steep a vertex is, and what its removal costs by that.
#include "decimate/importance_cost.hpp"

#include <cmath>
#include <numbers>
#include <vector>

#include <catch2/catch.hpp>

namespace winnow {

namespace {

// A pyramid of so many sides, `height` above its base of this radius.
std::vector<Point> pyramid(std::size_t sides, double height, double radius = 1) {
  std::vector<Point> seen;
  for (std::size_t i = 0; i < sides; ++i) {
    const double angle = 2 * std::numbers::pi * static_cast<double>(i) / static_cast<double>(sides);
    seen.push_back({radius * std::cos(angle), radius * std::sin(angle), -height});
  }
  return seen;
}

double importance(const std::vector<Point>& seen) {
  return visual_importance(shape_of({seen, true}));
}

double cost(const std::vector<Point>& seen) {
  return ImportanceOfRemoval({seen, true})(0);
}

}  // namespace

TEST_CASE("a flat vertex is of no importance") {
  CHECK(importance(pyramid(6, 0)) == 0);
  CHECK(importance({{0, 0, 0}, {0, 0, 0}, {0, 0, 0}}) == 0);
}

TEST_CASE("a circular cone is as important as it is steep, and more where it is a needle") {
  for (const double height : {1e-6, 0.1, 1.0, 10.0}) {
    CAPTURE(height);
    CHECK(importance(pyramid(10'000, height)) ==
          Approx(height * std::sqrt(1 + height * height)).epsilon(1e-6));
  }
}

TEST_CASE("the unit of length does not count for the importance, and squared for the cost") {
  std::vector<Point> large;
  const auto small = pyramid(5, 0.3);
  for (const Point& p : small) large.push_back(1024.0 * p);
  CHECK(importance(large) == importance(small));
  CHECK(cost(large) == 1024.0 * 1024.0 * cost(small));
}

TEST_CASE("the same height costs the same, however large the faces are") {
  const double one = cost(pyramid(6, 1e-3));
  CHECK(one > 0);
  CHECK(cost(pyramid(6, 1e-3, 10)) == Approx(one).epsilon(1e-4));
  CHECK(cost(pyramid(6, 1e-3, 100)) == Approx(one).epsilon(1e-4));
  CHECK(cost(pyramid(6, 2e-3, 100)) == Approx(4 * one).epsilon(1e-4));
}

TEST_CASE("a needle costs no less than a dent of the same height") {
  for (const double radius : {0.3, 0.1, 0.01}) {
    CAPTURE(radius);
    CHECK(cost(pyramid(6, 1, radius)) > cost(pyramid(6, 1, 10)));
  }
}

TEST_CASE("a boundary costs the square of its height, straight ones nothing") {
  const auto boundary = [](double height) {
    return std::vector<Point>{{1, -height, 0}, {0.5, 1, 0}, {-1, -height, 0}};
  };
  const auto cost = [&](double height) {
    const auto seen = boundary(height);
    return ImportanceOfRemoval({seen, false})(0);
  };
  CHECK(cost(0) == 0);
  CHECK(cost(0.25) > 0);
  CHECK(cost(0.5) == 4 * cost(0.25));
}

}  // namespace winnow
