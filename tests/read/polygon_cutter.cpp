// Polygons as triangles: they cover the polygon, no more and no less, and keep its sense.
#include "read/polygons/polygon_cutter.hpp"

#include "support/random.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <vector>

#include <catch2/catch.hpp>

namespace winnow::test {

namespace {

using Polygon = std::vector<Point>;

Point turned_in_space(const Point& p) {
  const double c = std::cos(0.7);
  const double s = std::sin(0.7);
  const Point q{c * p[0] - s * p[1], s * p[0] + c * p[1], p[2]};
  return {q[0] + 3, c * q[1] - s * q[2] - 5, s * q[1] + c * q[2] + 100};
}

Polygon in_space(Polygon polygon) {
  for (Point& corner : polygon) corner = turned_in_space(corner);
  return polygon;
}

// Around a middle, at random distances from it.
Polygon star(Random& random, std::size_t n) {
  Polygon out;
  for (std::size_t i = 0; i < n; ++i) {
    const double angle = 6.283185307179586 * static_cast<double>(i) / static_cast<double>(n);
    const double radius = 0.2 + random.unit();
    out.push_back({radius * std::cos(angle), radius * std::sin(angle), 0});
  }
  return out;
}

// A band that winds around itself.
Polygon spiral(std::size_t n) {
  Polygon out;
  for (std::size_t i = 0; i < n; ++i) {
    const double angle = 0.02 * static_cast<double>(i);
    out.push_back({(1 + angle) * std::cos(angle), (1 + angle) * std::sin(angle), 0});
  }
  for (std::size_t i = n; i-- > 0;) {
    const double angle = 0.02 * static_cast<double>(i);
    out.push_back({(2.5 + angle) * std::cos(angle), (2.5 + angle) * std::sin(angle), 0});
  }
  std::reverse(out.begin(), out.end());
  return out;
}

// Teeth of random heights on an even ground, some of them equal.
Polygon comb(Random& random, std::size_t n) {
  Polygon out{{0, 0, 0}, {static_cast<double>(n), 0, 0}};
  for (std::size_t i = n; i-- > 1;)
    out.push_back(
        {static_cast<double>(i), i % 2 == 0 ? 1 : 2 + static_cast<double>(random.below(3)), 0});
  out.push_back({0, 1, 0});
  return out;
}

// Squares on a lattice: many corners in one line, and many at one height.
Polygon staircase(std::size_t n) {
  Polygon out{{0, 0, 0}};
  for (std::size_t i = 0; i < n; ++i) {
    const auto at = static_cast<double>(i);
    out.push_back({at + 1, at, 0});
    out.push_back({at + 1, at + 1, 0});
  }
  for (std::size_t i = n; i-- > 0;) out.push_back({0, static_cast<double>(i) + 0.5, 0});
  return out;
}

// A square with a square hole, linked by two edges in one place.
Polygon with_hole() {
  return {{0, 0, 0}, {4, 0, 0}, {4, 4, 0}, {0, 4, 0}, {0, 0, 0},
          {1, 1, 0}, {1, 3, 0}, {3, 3, 0}, {3, 1, 0}, {1, 1, 0}};
}

double doubled_area_of(const Polygon& polygon, Point& normal) {
  Point sum{};
  for (std::size_t i = 2; i < polygon.size(); ++i)
    sum = sum + cross(polygon[i - 1] - polygon[0], polygon[i] - polygon[0]);
  normal = unit(sum);
  return length(sum);
}

void check_cut(const Polygon& polygon) {
  CAPTURE(polygon.size());
  PolygonCutter cutter;
  const auto triangles = cutter.cut(polygon);
  REQUIRE(triangles.size() == polygon.size() - 2);
  Point normal;
  const double area = doubled_area_of(polygon, normal);
  double sum = 0;
  double least = 0;
  std::map<std::array<std::uint32_t, 2>, int> sides;
  for (const auto& [a, b, c] : triangles) {
    const double one = dot(cross(polygon[b] - polygon[a], polygon[c] - polygon[a]), normal);
    least = std::min(least, one);
    sum += one;
    for (const auto& [from, to] : {std::pair{a, b}, std::pair{b, c}, std::pair{c, a}})
      ++sides[{from, to}];
  }
  CHECK(least >= -1e-8 * area);
  CHECK(sum == Approx(area).epsilon(1e-8));
  // Each side of the polygon once, each diagonal once in either direction.
  const auto n = static_cast<std::uint32_t>(polygon.size());
  for (std::uint32_t i = 0; i < n; ++i) CHECK(sides.count({i, (i + 1) % n}) == 1);
  for (const auto& [side, times] : sides) {
    CHECK(times == 1);
    const bool own = side[1] == (side[0] + 1) % n;
    CHECK(sides.contains({side[1], side[0]}) != own);
  }
}

}  // namespace

TEST_CASE("polygons of any form are cut into what they cover") {
  Random random(5);
  for (const std::size_t n : {4, 5, 7, 12, 40, 300, 5000}) {
    for (int i = 0; i < 20; ++i) {
      check_cut(star(random, n));
      check_cut(in_space(star(random, n)));
      check_cut(in_space(comb(random, n)));
    }
    check_cut(comb(random, n));
    check_cut(spiral(n));
    check_cut(in_space(spiral(n)));
    check_cut(staircase(n));
    check_cut(in_space(staircase(n)));
  }
}

TEST_CASE("a polygon with a hole is cut around it") {
  check_cut(with_hole());
  check_cut(in_space(with_hole()));
}

TEST_CASE("a convex polygon is a fan around its first corner") {
  const Polygon square{{0, 0, 0}, {0.5, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
  PolygonCutter cutter;
  using Fan = std::vector<std::array<std::uint32_t, 3>>;
  CHECK(cutter.cut(square) == Fan{{0, 1, 2}, {0, 2, 3}, {0, 3, 4}});
}

TEST_CASE("polygons that cross themselves are not cut") {
  PolygonCutter cutter;
  // Bow ties of equal and of unequal halves, and a five-pointed star in one line.
  CHECK(cutter.cut(Polygon{{0, 0, 0}, {1, 1, 0}, {1, 0, 0}, {0, 1, 0}}).empty());
  CHECK(cutter.cut(Polygon{{0, 0, 0}, {2, 2, 0}, {2, 0, 0}, {0, 1, 0}}).empty());
  Polygon pentagram;
  for (int i = 0; i < 5; ++i)
    pentagram.push_back({std::cos(2.5132741 * i), std::sin(2.5132741 * i), 0});
  CHECK(cutter.cut(pentagram).empty());
  // One without any area has nothing to be cut wrongly.
  CHECK(cutter.cut(Polygon{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {1, 0, 0}}).size() == 2);
  CHECK(cutter.cut(Polygon{{0, 0, 0}, {1, 0, 0}, {NAN, 1, 0}, {0, 1, 0}}).empty());
}

TEST_CASE("cutting a polygon takes no time that grows with the square of its corners", "[long]") {
  Random random(9);
  // Ten times this would take minutes if it did.
  check_cut(star(random, 200'000));
  check_cut(spiral(100'000));
}

TEST_CASE("whoever wants to stop is heard at every stage of cutting", "[long]") {
  Random random(10);
  struct Stopped {};
  Polygon bow = star(random, 200'000);
  std::swap(bow[0], bow[100'000]);
  for (const Polygon& polygon : {star(random, 200'000), spiral(100'000), bow}) {
    std::size_t asked = 0;
    std::size_t stop_at = SIZE_MAX;
    PolygonCutter cutter([&] {
      if (++asked == stop_at) throw Stopped();
    });
    const auto whole = cutter.cut(polygon);
    const std::size_t all = asked;
    // At least once in so many of the n log n steps.
    CHECK(all >= 20 * polygon.size() / Pace::steps);
    for (std::size_t at = 1; at <= all; at += 1 + all / 20) {
      asked = 0;
      stop_at = at;
      CHECK_THROWS_AS(cutter.cut(polygon), Stopped);
    }
    stop_at = SIZE_MAX;
    CHECK(cutter.cut(polygon) == whole);
  }
}

}  // namespace winnow::test
