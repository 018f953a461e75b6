// The order of vertices and faces in a mesh decides nothing.
#include "support/surfaces.hpp"
#include "support/tile_meshes.hpp"

#include <algorithm>
#include <numeric>
#include <vector>

#include <catch2/catch.hpp>

namespace winnow {

namespace {

// A bumpy ball on which nothing is as large as anything else.
std::vector<Triangle> uneven_ball() {
  std::vector<Triangle> triangles = test::ball(24, 0.2);
  for (Triangle& triangle : triangles) {
    for (Point& p : triangle) {
      const double factor = 1 + 0.01 * std::sin(31 * p[0] + 17 * p[1] + 23 * p[2]);
      p = factor * p;
    }
  }
  return triangles;
}

// Each with its lowest corner first, in order.
std::vector<Triangle> sorted(std::vector<Triangle> triangles) {
  for (Triangle& t : triangles)
    std::rotate(t.begin(), std::min_element(t.begin(), t.end()), t.end());
  std::sort(triangles.begin(), triangles.end());
  return triangles;
}

}  // namespace

TEST_CASE("faces in another order, each with another corner first, leave the same surface") {
  const Refine cost = GENERATE(Refine::volume, Refine::importance);
  CAPTURE(cost);
  std::vector<Triangle> triangles = uneven_ball();
  TileMesh mesh = test::tile_of(triangles);
  test::decimate(mesh, cost, 200);
  const auto left = sorted(test::live_triangles(mesh));
  REQUIRE(left.size() == 200);
  for (std::uint64_t seed = 1; seed <= 5; ++seed) {
    CAPTURE(seed);
    test::Random random(seed);
    for (std::size_t i = triangles.size(); i > 1; --i)
      std::swap(triangles[i - 1], triangles[random.below(i)]);
    for (Triangle& t : triangles) {
      std::rotate(t.begin(), t.begin() + static_cast<std::ptrdiff_t>(random.below(3)), t.end());
    }
    // Vertices are numbered as they come.
    TileMesh other = test::tile_of(triangles);
    test::decimate(other, cost, 200);
    CHECK(sorted(test::live_triangles(other)) == left);
  }
}

}  // namespace winnow
