// Where meshes are seen from.
#include "picture/camera.hpp"

#include <limits>
#include <vector>

#include <catch2/catch.hpp>

namespace winnow::test {

namespace {

void check_same_point(const Point& a, const Point& b) {
  for (std::size_t axis = 0; axis < 3; ++axis) CHECK(a[axis] == Approx(b[axis]).margin(1e-12));
}

}  // namespace

TEST_CASE("a camera has three directions at right angles, whatever it looks along") {
  std::vector<Point> viewers{
      {1e-300, 0, 0}, {0, 1e300, 1e300}, {0, std::numeric_limits<double>::max(), 0}};
  for (const double x : {-1.0, 0.0, 1.0}) {
    for (const double y : {-1.0, 0.0, 1.0}) {
      for (const double z : {-1.0, 0.0, 1.0}) {
        if (x != 0 || y != 0 || z != 0) viewers.push_back({x, y, z});
      }
    }
  }
  for (const Upright upright : {Upright::y, Upright::z}) {
    for (const Point& viewer : viewers) {
      const Camera camera = camera_for(View::from, viewer, upright);
      check_same_point(cross(camera.right, camera.up), camera.towards);
      check_same_point({length(camera.right), length(camera.up), length(camera.towards)},
                       {1, 1, 1});
      CHECK(dot(camera.towards, {viewer[0] / 2, viewer[1] / 2, viewer[2] / 2}) > 0);
    }
  }
}

TEST_CASE("what is up is up, and from above the front is below") {
  const Camera front = camera_for(View::front, {}, Upright::y);
  check_same_point(front.up, {0, 1, 0});
  check_same_point(front.right, {1, 0, 0});
  const Camera tall = camera_for(View::front, {}, Upright::z);
  check_same_point(tall.up, {0, 0, 1});
  check_same_point(tall.right, {1, 0, 0});
  const Camera top = camera_for(View::top, {}, Upright::y);
  check_same_point(top.up, {0, 0, -1});
  check_same_point(top.right, {1, 0, 0});
  const Camera map = camera_for(View::top, {}, Upright::z);
  check_same_point(map.up, {0, 1, 0});
  check_same_point(map.right, {1, 0, 0});
}

TEST_CASE("from the default view the three axes are equally long") {
  for (const Upright upright : {Upright::y, Upright::z}) {
    const Camera iso = camera_for(View::iso, {}, upright);
    for (const Point& axis : {Point{1, 0, 0}, Point{0, 1, 0}, Point{0, 0, 1}}) {
      const Point seen = iso.seen(axis);
      CHECK(seen[0] * seen[0] + seen[1] * seen[1] == Approx(2.0 / 3));
    }
    CHECK(iso.seen(upright == Upright::y ? Point{0, 1, 0} : Point{0, 0, 1})[1] > 0.8);
  }
}

}  // namespace winnow::test
