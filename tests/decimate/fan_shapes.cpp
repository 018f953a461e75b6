// The area, the perimeter and the spread of the normals of fans that are known.
#include "decimate/fan.hpp"

#include <cmath>
#include <numbers>
#include <vector>

#include <catch2/catch.hpp>

namespace winnow {

namespace {

FanShape shape(const std::vector<Point>& seen, bool closed) {
  return shape_of({seen, closed});
}

}  // namespace

TEST_CASE("the normals of a flat vertex do not spread") {
  CHECK(shape({{1, 0, 0}, {0, 2, 0}, {-1, -1, 0}}, true).spread == 0);
  CHECK(shape({{1, 0, 0}, {0, 2, 0}}, false).spread == 0);
}

TEST_CASE("the edge of a cube has two normals at right angles, its corner three") {
  CHECK(shape({{1, 0, 0}, {0, 1, 0}, {-1, 0, 0}, {0, 0, 1}}, true).cosine() ==
        Approx(1 / std::sqrt(2.0)).epsilon(1e-14));
  CHECK(shape({{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, true).cosine() ==
        Approx(1 / std::sqrt(3.0)).epsilon(1e-14));
}

TEST_CASE("two faces back to back cancel out") {
  CHECK(shape({{1, 0, 0}, {0, 1, 0}, {1, 0, 0}}, false).spread == 1);
}

TEST_CASE("a slope that is next to nothing keeps its digits") {
  for (const double height : {1e-2, 1e-5, 1e-9}) {
    CAPTURE(height);
    // A pyramid over a square.
    const FanShape pyramid =
        shape({{1, 0, -height}, {0, 1, -height}, {-1, 0, -height}, {0, -1, -height}}, true);
    const double tangent = height * std::sqrt(2.0);
    CHECK(pyramid.sine() / pyramid.cosine() == Approx(tangent).epsilon(1e-9));
  }
}

TEST_CASE("the area and the perimeter of a fan, which an open one closes by a line") {
  const FanShape closed = shape({{3, 0, 0}, {0, 4, 0}, {-3, 0, 0}, {0, -4, 0}}, true);
  CHECK(closed.area == 24);
  CHECK(closed.perimeter == 20);
  const FanShape open = shape({{3, 0, 0}, {0, 4, 0}, {-3, 0, 0}}, false);
  CHECK(open.area == 12);
  CHECK(open.perimeter == 16);
}

TEST_CASE("faces without an area have a shape as well") {
  CHECK(shape({{1, 0, 0}, {2, 0, 0}}, false).spread == 0);
  CHECK(shape({{0, 0, 0}, {0, 0, 0}, {0, 0, 0}}, true).area == 0);
}

}  // namespace winnow
