// A vertex is hyperbolic where its neighbours enclose it: the paper's figure 5.
#include "decimate/fan.hpp"
#include "decimate/hyperbolic.hpp"
#include "support/random.hpp"

#include <cmath>
#include <vector>

#include <catch2/catch.hpp>

namespace winnow {

namespace {

bool hyperbolic(const std::vector<Point>& seen) {
  return !supporting_direction(seen);
}

}  // namespace

TEST_CASE("a fan that is flat or rises to an apex is not hyperbolic") {
  CHECK_FALSE(hyperbolic({{1, 0, 0}, {-1, 1, 0}, {-1, -1, 0}}));
  CHECK_FALSE(hyperbolic({{1, 0, -1}, {0, 1, -1}, {-1, 0, -1}, {0, -1, -1}}));
  CHECK_FALSE(hyperbolic({{1, 0, -3}, {0, 1, -3}, {-1, 0, -3}, {0, -1, -1}}));
  CHECK_FALSE(hyperbolic({{1, 0, 0}, {0, 1, 0}}));
}

TEST_CASE("a saddle is hyperbolic") {
  CHECK(hyperbolic({{1, 0, 1}, {0, 1, -1}, {-1, 0, 1}, {0, -1, -1}}));
  CHECK(hyperbolic({{5, 0, 2}, {0, 0.1, -0.1}, {-1, 0, 1}, {0, -3, -1}}));
  CHECK(hyperbolic({{1, 1, 1}, {1, -1, -1}, {-1, 1, -1}, {-1, -1, 1}}));
}

TEST_CASE("a saddle that noise or rounding could have made is not") {
  CHECK_FALSE(hyperbolic({{1, 0, 1e-7}, {0, 1, -1e-7}, {-1, 0, 1e-7}, {0, -1, -1e-7}}));
  CHECK_FALSE(hyperbolic({{1, 0, 0.03}, {0, 1, -0.03}, {-1, 0, 0.03}, {0, -1, -0.03}}));
}

TEST_CASE("no vertex of an L-shaped solid is hyperbolic") {
  const std::vector<Point> outline{{0, 0, 0}, {2, 0, 0}, {2, 1, 0}, {1, 1, 0}, {1, 2, 0}, {0, 2, 0}};
  std::vector<Point> positions = outline;
  for (const Point& p : outline) positions.push_back(p + Point{0, 0, 1});
  // Both ends are fans about the corner that turns inwards.
  std::vector<FaceVertices> faces;
  for (VertexNumber i = 0; i < 6; ++i) {
    const VertexNumber next = (i + 1) % 6;
    faces.push_back({i, next, next + 6});
    faces.push_back({i, next + 6, i + 6});
    if (i == 3 || next == 3) continue;
    faces.push_back({3, next, i});
    faces.push_back({9, i + 6, next + 6});
  }
  const TileMesh mesh(positions, faces, std::vector<std::uint8_t>(12, 0));
  Fan fan;
  for (VertexNumber v = 0; v < 12; ++v) {
    REQUIRE(fan.find(mesh, v));
    CHECK(fan.closed());
    CHECK(supporting_direction(fan.seen()));
  }
}

TEST_CASE("no neighbour is behind a supporting direction") {
  test::Random random(31);
  for (int round = 0; round < 2000; ++round) {
    std::vector<Point> seen(random.between(2, 8));
    for (Point& p : seen) p = {random.real(-1, 1), random.real(-1, 1), random.real(-1, 1)};
    const auto ahead = supporting_direction(seen);
    if (!ahead) {
      // Then no direction at all has all of them ahead.
      for (int tries = 0; tries < 200; ++tries) {
        const Point any{random.real(-1, 1), random.real(-1, 1), random.real(-1, 1)};
        bool some_behind = false;
        for (const Point& p : seen) some_behind |= dot(any, p) < 0;
        REQUIRE(some_behind);
      }
      continue;
    }
    REQUIRE(length(*ahead) == Approx(1));
    for (const Point& p : seen) REQUIRE(dot(*ahead, p) >= -0.1001 * length(p));
  }
}

}  // namespace winnow
