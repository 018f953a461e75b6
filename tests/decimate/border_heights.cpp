// How far a boundary vertex is from the line that is left without it.
#include "decimate/fan.hpp"

#include <vector>

#include <catch2/catch.hpp>

namespace winnow {

namespace {

double height(const Point& before, const Point& after, const Point& off = {}) {
  const std::vector<Point> seen{before, {0, 1, 0}, after};
  return boundary_height({seen, false, off});
}

}  // namespace

TEST_CASE("a straight boundary has no height") {
  CHECK(height({1, 0, 0}, {-3, 0, 0}) == 0);
  CHECK(height({1, 2, 3}, {-2, -4, -6}) == 0);
}

TEST_CASE("a corner is as high as it stands out from the line between its neighbours") {
  CHECK(height({3, 0, 0}, {0, 0, 4}) == Approx(2.4));
  CHECK(height({2, -1, 0}, {-5, -1, 0}) == Approx(1));
}

TEST_CASE("a spike is as high as its nearer end is far") {
  CHECK(height({3, 0, 0}, {5, 0, 0}) == 3);
  CHECK(height({5, 1, 0}, {3, 0, 0}) == 3);
  CHECK(height({0, 2, 0}, {0, 2, 0}) == 2);
}

TEST_CASE("a boundary is straight where rounding may have bent it, each axis by itself") {
  const Point before{2, 0, 0.001};
  const Point after{-2, 0, 0};
  CHECK(height(before, after, {0, 0, 0.001}) == 0);
  CHECK(height(before, after, {0, 0, 0.0001}) > 0);
  // What is unknown along the boundary says nothing of heights.
  CHECK(height(before, after, {0.1, 0, 0.0001}) > 0);
}

}  // namespace winnow
