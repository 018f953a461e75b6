// What is nearest to a point, against a look at every face.
#include "base/closest_point.hpp"
#include "decimate/surface_patch.hpp"
#include "support/random.hpp"

#include <cmath>
#include <limits>
#include <vector>

#include <catch2/catch.hpp>

namespace winnow::test {

namespace {

Point random_place(Random& random, double size) {
  return {random.real(-size, size), random.real(-size, size), random.real(-size, size)};
}

// Small faces; those that follow each other need not be close.
std::vector<Triangle> random_faces(Random& random, std::size_t count, const Point& middle) {
  std::vector<Triangle> faces;
  while (faces.size() < count) {
    const Point place = middle + random_place(random, 1);
    Triangle& face = faces.emplace_back();
    for (Point& corner : face) corner = place + random_place(random, 0.1);
  }
  return faces;
}

double squared_distance(const Point& point, const Triangle& face) {
  const Point away = point - closest_point(point, face);
  return dot(away, away);
}

struct Nearest {
  double squared = std::numeric_limits<double>::max();
  std::size_t face = 0;
};

template <typename Counts>
Nearest nearest_of(const std::vector<Triangle>& faces, const Point& point, const Counts& counts) {
  Nearest nearest;
  for (std::size_t f = 0; f < faces.size(); ++f) {
    const double squared = squared_distance(point, faces[f]);
    if (counts(faces[f]) && squared < nearest.squared) nearest = {squared, f};
  }
  return nearest;
}

}  // namespace

TEST_CASE("a patch finds what a look at every face finds") {
  Random random(1);
  for (const std::size_t count : {1, 4, 5, 17, 1000}) {
    for (const Point& middle : {Point{0, 0, 0}, Point{1e5, -2e6, 3}}) {
      const std::vector<Triangle> faces = random_faces(random, count, middle);
      const SurfacePatch patch(faces);
      SurfacePatch::Hint last = SurfacePatch::unknown;
      for (int i = 0; i < 200; ++i) {
        CAPTURE(count, i);
        const Point point = middle + random_place(random, 1.5);
        const Point normal = random_place(random, 1);
        const auto facing = [&](const Triangle& t) { return dot(doubled_area(t), normal) >= 0; };
        const Nearest nearest = nearest_of(faces, point, [](const Triangle&) { return true; });
        // Whatever a search begins with.
        for (SurfacePatch::Hint hint : {SurfacePatch::unknown, last, count / 2}) {
          CHECK(patch.squared_distance(point, hint) == nearest.squared);
          CHECK(squared_distance(point, faces[hint]) == nearest.squared);
          last = hint;
        }
        for (SurfacePatch::Hint hint : {SurfacePatch::unknown, last, count / 2})
          CHECK(patch.opposed(point, normal, hint) != facing(faces[nearest.face]));
        const auto way = patch.way_to_facing(point, normal);
        const Nearest best = nearest_of(faces, point, facing);
        REQUIRE(way.has_value() == (best.squared < std::numeric_limits<double>::max()));
        if (way) CHECK(dot(*way, *way) == best.squared);
      }
    }
  }
}

TEST_CASE("over a ridge a face is turned away if it is from one of both sides") {
  // Two faces of a steep roof; the point is over its ridge.
  const std::vector<Triangle> roof{{{{0, 0, 0}, {1, 0, 0}, {0.5, 1, -3}}},
                                   {{{1, 0, 0}, {0, 0, 0}, {0.5, -1, -3}}}};
  const SurfacePatch patch(roof);
  const Point above{0.5, 0, 1};
  for (SurfacePatch::Hint hint : {SurfacePatch::unknown, std::size_t{0}, std::size_t{1}}) {
    CHECK_FALSE(patch.opposed(above, {0, 0, 1}, hint));
    CHECK(patch.opposed(above, {0, 1, 0}, hint));
    CHECK(patch.opposed(above, {0, -1, 0}, hint));
  }
}

TEST_CASE("a patch without faces is at no distance") {
  const SurfacePatch patch({});
  SurfacePatch::Hint hint = SurfacePatch::unknown;
  CHECK(patch.squared_distance({0, 0, 0}, hint) == std::numeric_limits<double>::infinity());
  CHECK_FALSE(patch.opposed({0, 0, 0}, {0, 0, 1}, hint));
  CHECK_FALSE(patch.way_to_facing({0, 0, 0}, {0, 0, 1}).has_value());
}

}  // namespace winnow::test
