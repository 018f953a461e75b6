// The volume that a collapse sweeps, and the share of the half space that a vertex takes.
#include "decimate/volume_cost.hpp"

#include <cmath>
#include <numbers>
#include <vector>

#include <catch2/catch.hpp>

namespace winnow {

namespace {

// A pyramid of so many sides, `height` above its base of radius 1.
std::vector<Point> pyramid(std::size_t sides, double height) {
  std::vector<Point> seen;
  for (std::size_t i = 0; i < sides; ++i) {
    const double angle = 2 * std::numbers::pi * static_cast<double>(i) / static_cast<double>(sides);
    seen.push_back({std::cos(angle), std::sin(angle), -height});
  }
  return seen;
}

}  // namespace

TEST_CASE("the corner of a cube is a sixth of it, whichever way it goes") {
  const std::vector<Point> corner{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  for (std::size_t into = 0; into < 3; ++into)
    CHECK(swept_volume({corner, true}, into) == Approx(1.0 / 6).epsilon(1e-14));
}

TEST_CASE("a pyramid is swept as a whole") {
  const auto seen = pyramid(4, 1);
  for (std::size_t into = 0; into < 4; ++into)
    CHECK(swept_volume({seen, true}, into) == Approx(2.0 / 3).epsilon(1e-14));
}

TEST_CASE("what is taken away and what is added do not cancel") {
  // A saddle: one neighbour up, the next one down.
  const std::vector<Point> saddle{{1, 0, 1}, {0, 1, -1}, {-1, 0, 1}, {0, -1, -1}};
  CHECK(swept_volume({saddle, true}, 0) == Approx(2.0 / 3).epsilon(1e-14));
}

TEST_CASE("a flat vertex takes the half space, a circular cone what its angle says") {
  CHECK(share_of_angle(shape_of({pyramid(6, 0), true})) == 1);
  for (const double height : {0.1, 1.0, 10.0}) {
    CAPTURE(height);
    const double share = 1 - height / std::hypot(height, 1);
    CHECK(share_of_angle(shape_of({pyramid(10'000, height), true})) == Approx(share).epsilon(1e-6));
  }
}

TEST_CASE("the sharper a vertex, the costlier the same volume") {
  double last = 0;
  for (const double height : {0.01, 0.1, 1.0, 10.0, 100.0, 1e6}) {
    const auto seen = pyramid(8, height);
    const FanView fan{seen, true};
    const double costlier = VolumeOfRemoval(fan)(0) / swept_volume(fan, 0);
    CHECK(costlier > last);
    CHECK(std::isfinite(costlier));
    last = costlier;
  }
}

TEST_CASE("a boundary costs by the area that it loses, to its neighbours alike") {
  const std::vector<Point> corner{{1, 0, 0}, {0.5, 0.5, 0}, {0, 1, 0}};
  const std::vector<Point> straight{{1, 0, 0}, {0.5, 0.5, 0}, {-1, 0, 0}};
  CHECK(VolumeOfRemoval({straight, false})(0) == 0);
  const double one = VolumeOfRemoval({corner, false})(0);
  CHECK(one > 0);
  CHECK(VolumeOfRemoval({corner, false})(2) == one);
  std::vector<Point> large;
  for (const Point& p : corner) large.push_back(2.0 * p);
  CHECK(VolumeOfRemoval({large, false})(0) == 8 * one);
}

}  // namespace winnow
