// How far points are from a face: the same bits from the kernels of every instruction set, and what
// doubles say.
#include "base/closest_point.hpp"
#include "fit/face_index.hpp"
#include "support/random.hpp"
#include "support/runnable.hpp"

#include <cmath>
#include <cstring>
#include <memory>

#include <catch2/catch.hpp>

namespace winnow::test {

namespace {

Point some_point(Random& random, double size) {
  return {random.real(-size, size), random.real(-size, size), random.real(-size, size)};
}

// Sometimes a needle, a line or a point.
Triangle some_face(Random& random) {
  Triangle t{some_point(random, 1), some_point(random, 1), some_point(random, 1)};
  const auto kind = random.below(8);
  if (kind == 0) t[2] = t[0] + random.real(-1, 2) * (t[1] - t[0]);
  if (kind == 1) t[1] = t[0];
  if (kind == 2) t[2] = t[1] = t[0];
  if (kind == 3) t[2] = t[1] + 1e-6 * some_point(random, 1);
  return t;
}

// Rounding may take any point of a line for the nearest inside of it.
double distance(const Point& p, const Triangle& t) {
  double least = length(p - closest_point(p, t));
  for (std::size_t i = 0; i < 3; ++i) {
    const Point& next = t[(i + 1) % 3];
    least = std::min(least, length(p - closest_point(p, {t[i], next, next})));
  }
  return least;
}

}  // namespace

TEST_CASE("points are as far from faces by every instruction set, and by doubles") {
  Random random(5);
  const auto kernels = runnable(WINNOW_KERNELS(near_kernel));
  for (int round = 0; round < 500; ++round) {
    auto group = std::make_unique<PointGroup>();
    std::vector<Point> points;
    for (std::size_t i = 0; i < PointGroup::capacity; ++i) {
      points.push_back(some_point(random, 1));
      for (std::size_t axis = 0; axis < 3; ++axis) {
        points[i][axis] = nearest_float(points[i][axis]);
        group->place[axis][i] = static_cast<float>(points[i][axis]);
      }
      group->least[i] = group->next[i] = 1e30F;
      group->nearest[i] = -1;
    }
    std::vector<Triangle> faces(1 + random.below(6));
    std::vector<FaceBeside> beside;
    for (Triangle& t : faces) {
      t = some_face(random);
      FaceBeside& face = beside.emplace_back();
      face.face = flat_face(t, 1);
      for (std::size_t axis = 0; axis < 3; ++axis)
        face.corner[axis] = static_cast<float>(t[0][axis]);
    }
    const PointGroup before = *group;
    const float most =
        kernels[0].second(*group, PointGroup::capacity, beside.data(), beside.size(), 7);
    float largest = 0;
    for (std::size_t i = 0; i < points.size(); ++i) {
      double least = 1e30;
      for (const Triangle& t : faces) least = std::min(least, distance(points[i], t));
      CHECK(std::abs(std::sqrt(double{group->least[i]}) - least) < 2e-6);
      CHECK(group->next[i] >= group->least[i]);
      CHECK((faces.size() > 1) == (group->next[i] < 1e30F));
      const auto nearest = static_cast<std::size_t>(group->nearest[i] - 7);
      REQUIRE(nearest < faces.size());
      CHECK(std::abs(distance(points[i], faces[nearest]) - least) < 4e-6);
      largest = std::max(largest, group->least[i]);
    }
    CHECK(most == largest);
    for (const auto& [name, kernel] : kernels) {
      PointGroup own = before;
      const float told = kernel(own, PointGroup::capacity, beside.data(), beside.size(), 7);
      INFO(name);
      CHECK(told == most);
      CHECK(std::memcmp(&own, group.get(), sizeof own) == 0);
    }
  }
}

}  // namespace winnow::test
