// The nearest point of a triangle is in it, and no other point of it is nearer.
#include "base/closest_point.hpp"

#include "support/random.hpp"

#include <algorithm>
#include <cmath>

#include <catch2/catch.hpp>

namespace winnow {

namespace {

Point random_point(test::Random& random, double half) {
  return {random.real(-half, half), random.real(-half, half), random.real(-half, half)};
}

double distance(const Point& a, const Point& b) {
  return length(a - b);
}

// By bisecting nothing and knowing nothing: the best of a fine net over the triangle.
double distance_by_trying(const Point& p, const Triangle& t) {
  constexpr int steps = 60;
  double best = distance(p, t[0]);
  for (int i = 0; i <= steps; ++i) {
    for (int j = 0; i + j <= steps; ++j) {
      const Point at = t[0] + (1.0 * i / steps * (t[1] - t[0]) + 1.0 * j / steps * (t[2] - t[0]));
      best = std::min(best, distance(p, at));
    }
  }
  return best;
}

}  // namespace

TEST_CASE("the nearest point of a triangle is as near as any other of it") {
  test::Random random(700);
  for (int round = 0; round < 400; ++round) {
    const Triangle t{random_point(random, 1), random_point(random, 1), random_point(random, 1)};
    const Point p = random_point(random, 2);
    const Point nearest = closest_point(p, t);
    const double net = distance_by_trying(p, t);
    CAPTURE(round);
    CHECK(distance(p, nearest) <= net + 1e-12);
    CHECK(distance(p, nearest) >= net - 0.1);  // the net is 1/60 of a side of at most 3.5 wide
    // It lies in the plane, and on the inner side of every side.
    const Point normal = doubled_area(t);
    CHECK(std::abs(dot(nearest - t[0], normal)) <= 1e-12 * length(normal));
    for (std::size_t corner = 0; corner < 3; ++corner) {
      const Point side = t[(corner + 1) % 3] - t[corner];
      CHECK(dot(cross(side, nearest - t[corner]), normal) >= -1e-10);
    }
  }
}

TEST_CASE("points over the inside, the sides and the corners of a triangle") {
  const Triangle t{{{0, 0, 0}, {2, 0, 0}, {0, 2, 0}}};
  CHECK(closest_point({0.5, 0.5, 3}, t) == Point{0.5, 0.5, 0});
  CHECK(closest_point({0.5, -1, 1}, t) == Point{0.5, 0, 0});
  CHECK(closest_point({-1, 0.25, -1}, t) == Point{0, 0.25, 0});
  CHECK(closest_point({2, 2, 5}, t) == Point{1, 1, 0});
  CHECK(closest_point({-1, -2, 1}, t) == Point{0, 0, 0});
  CHECK(closest_point({5, -1, 1}, t) == Point{2, 0, 0});
  CHECK(closest_point({-1, 7, 1}, t) == Point{0, 2, 0});
}

TEST_CASE("a triangle of no area is a segment or a point") {
  const Triangle segment{{{0, 0, 0}, {4, 0, 0}, {1, 0, 0}}};
  CHECK(distance(closest_point({3, 2, 0}, segment), {3, 0, 0}) < 1e-15);
  CHECK(distance(closest_point({-3, 2, 0}, segment), {0, 0, 0}) < 1e-15);
  CHECK(distance(closest_point({9, 2, 0}, segment), {4, 0, 0}) < 1e-15);
  const Triangle point{{{1, 2, 3}, {1, 2, 3}, {1, 2, 3}}};
  CHECK(closest_point({5, 5, 5}, point) == Point{1, 2, 3});
}

TEST_CASE("needles keep their distance") {
  test::Random random(701);
  for (int round = 0; round < 500; ++round) {
    const Point a = random_point(random, 1);
    const Point b = a + random_point(random, 1);
    const double width = std::pow(10, random.real(-14, -6));
    const Triangle needle{a, b, a + (0.5 * (b - a) + random_point(random, width))};
    const Point p = random_point(random, 2);
    const double along = std::clamp(dot(p - a, b - a) / dot(b - a, b - a), 0.0, 1.0);
    CHECK(distance(p, closest_point(p, needle)) ==
          Approx(distance(p, a + along * (b - a))).margin(1e-5));
  }
}

// Where rounding takes all of a line for its inside, the place is still the nearest one.
TEST_CASE("a face whose corners are on one line has its nearest place there") {
  test::Random random(702);
  for (int round = 0; round < 2000; ++round) {
    const Point a = random_point(random, 1);
    const Point way = random_point(random, 1);
    const Triangle line{a, a + way, a + random.real(-1, 2) * way};
    const Point p = a + (random.real(-1, 2) * way + random_point(random, 0.01));
    double least = distance(p, a);
    for (std::size_t i = 0; i < 3; ++i) {
      const Triangle side{line[i], line[(i + 1) % 3], line[(i + 1) % 3]};
      least = std::min(least, distance(p, closest_point(p, side)));
    }
    CAPTURE(round);
    CHECK(distance(p, closest_point(p, line)) <= least + 1e-15);
  }
}

// Its corner is as thin as rounding can make that of a line.
TEST_CASE("a point above the inside of a needle has its nearest place there") {
  test::Random random(703);
  for (const double length : {1e3, 1e4, 5e4}) {
    const Triangle needle{Point{0, 0, 0}, Point{length, 0, 0}, Point{length, 1, 0}};
    for (int round = 0; round < 100; ++round) {
      const double x = length * random.real(0.2, 1);
      const Point p{x, x / length * random.real(0.1, 0.9), random.real(-0.01, 0.01)};
      CAPTURE(length, round);
      CHECK(distance(p, closest_point(p, needle)) == Approx(std::abs(p[2])).margin(0.005));
    }
  }
}

}  // namespace winnow
