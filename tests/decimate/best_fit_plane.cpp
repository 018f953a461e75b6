// The plane that fits best is known for some points, and no other fits random ones better.
#include "decimate/best_fit_plane.hpp"

#include "support/random.hpp"

#include <cmath>
#include <vector>

#include <catch2/catch.hpp>

namespace winnow {

namespace {

double squares(const Plane& plane, const std::vector<Point>& points) {
  double sum = 0;
  for (const Point& p : points) sum += plane.distance(p) * plane.distance(p);
  return sum;
}

Point direction(test::Random& random) {
  for (;;) {
    const Point p{random.real(-1, 1), random.real(-1, 1), random.real(-1, 1)};
    if (length(p) > 0.1) return (1 / length(p)) * p;
  }
}

}  // namespace

TEST_CASE("points of a plane are on the plane that fits them best") {
  const Plane level = best_fit_plane(std::vector<Point>{{1, 0, 3}, {0, 1, 3}, {-1, 0, 3}, {0, -1, 3}});
  CHECK(std::abs(level.normal[2]) == 1);
  CHECK(level.distance({0, 0, 0}) == 3);
  const std::vector<Point> oblique{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  const Plane plane = best_fit_plane(oblique);
  CHECK(squares(plane, oblique) < 1e-28);
  CHECK(plane.distance({0, 0, 0}) == Approx(1 / std::sqrt(3.0)).epsilon(1e-14));
}

TEST_CASE("a square whose corners rise and fall in turn is fitted by its middle plane") {
  const Plane plane =
      best_fit_plane(std::vector<Point>{{1, 1, 0.2}, {-1, 1, -0.2}, {-1, -1, 0.2}, {1, -1, -0.2}});
  CHECK(std::abs(plane.normal[2]) == Approx(1).epsilon(1e-14));
  CHECK(plane.distance({0, 0, 0.5}) == Approx(0.5).epsilon(1e-14));
}

TEST_CASE("no other plane fits better") {
  test::Random random(17);
  for (int round = 0; round < 300; ++round) {
    std::vector<Point> points(random.between(3, 9));
    for (Point& p : points) p = {random.real(-1, 1), 0.7 * random.real(-1, 1), 0.4 * random.real(-1, 1)};
    const Plane best = best_fit_plane(points);
    REQUIRE(length(best.normal) == Approx(1).epsilon(1e-13));
    const double least = squares(best, points);
    for (int tries = 0; tries < 60; ++tries) {
      Point normal = best.normal + random.real(0, 0.3) * direction(random);
      normal = (1 / length(normal)) * normal;
      REQUIRE(squares({best.through, normal}, points) >= least * (1 - 1e-12) - 1e-28);
    }
  }
}

}  // namespace winnow
