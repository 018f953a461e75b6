// Solid angles of things whose solid angles are known.
#include "decimate/hyperbolic.hpp"
#include "decimate/solid_angle.hpp"

#include <cmath>
#include <numbers>
#include <vector>

#include <catch2/catch.hpp>

namespace winnow {

namespace {

constexpr double pi = std::numbers::pi;

double of_fan(const std::vector<Point>& seen, bool closed) {
  const auto ahead = supporting_direction(seen);
  REQUIRE(ahead);
  return solid_angle_of_fan(seen, closed, *ahead);
}

std::vector<Point> cone(unsigned sides, double half_angle) {
  std::vector<Point> seen;
  for (unsigned i = 0; i < sides; ++i) {
    const double u = 2 * pi * i / sides;
    seen.push_back(
        {std::sin(half_angle) * std::cos(u), std::sin(half_angle) * std::sin(u), std::cos(half_angle)});
  }
  return seen;
}

}  // namespace

TEST_CASE("an octant is an eighth of the sphere, whatever the lengths") {
  CHECK(solid_angle({1, 0, 0}, {0, 1, 0}, {0, 0, 1}) == Approx(pi / 2).epsilon(1e-14));
  CHECK(solid_angle({7, 0, 0}, {0, 0.1, 0}, {0, 0, 1000}) == Approx(pi / 2).epsilon(1e-14));
  CHECK(solid_angle({0, 1, 0}, {1, 0, 0}, {0, 0, 1}) == Approx(-pi / 2).epsilon(1e-14));
}

TEST_CASE("a regular tetrahedron takes the known part of the view of its apex") {
  // The corners of a cube that are not next to each other.
  CHECK(of_fan({{0, 1, 1}, {1, 0, 1}, {1, 1, 0}}, true) == Approx(std::acos(23.0 / 27)).epsilon(1e-13));
}

TEST_CASE("the corner of a cube") {
  CHECK(of_fan({{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, true) == Approx(pi / 2).epsilon(1e-13));
  CHECK(of_fan({{0, 0, 1}, {0, 1, 0}, {1, 0, 0}}, true) == Approx(pi / 2).epsilon(1e-13));
}

TEST_CASE("a cone of many sides") {
  for (const double half : {0.3, 1.0, 1.4}) {
    CHECK(of_fan(cone(60, half), true) == Approx(2 * pi * (1 - std::cos(half))).epsilon(5e-3));
  }
}

TEST_CASE("a flat vertex sees its link take half of the view") {
  CHECK(of_fan(cone(6, pi / 2), true) == Approx(2 * pi).epsilon(1e-13));
  CHECK(of_fan({{1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {-1, -1, 0}}, true) == Approx(2 * pi).epsilon(1e-13));
}

TEST_CASE("in the middle of the edge of a cube it is the angle between the faces") {
  CHECK(of_fan({{1, 0, 0}, {0, 1, 0}, {-1, 0, 0}, {0, 0, 1}}, true) == Approx(pi).epsilon(1e-13));
}

TEST_CASE("an open fan that is flat has its plane angle") {
  CHECK(of_fan({{1, 0, 0}, {0, 1, 0}}, false) == Approx(pi / 2).epsilon(1e-13));
  CHECK(of_fan({{1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {-1, 0, 0}}, false) == Approx(pi).epsilon(1e-13));
}

}  // namespace winnow
