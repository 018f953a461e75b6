// What is flat goes before all that has a shape, at any scale.
#include "support/surfaces.hpp"
#include "support/tile_meshes.hpp"

#include <algorithm>

#include <catch2/catch.hpp>

namespace winnow {

TEST_CASE("a huge flat ground goes before a small ball above it") {
  const Refine cost = GENERATE(Refine::volume, Refine::importance);
  const double side = GENERATE(1.0, 1e6, 1e9);
  CAPTURE(cost, side);
  std::vector<Triangle> triangles = test::placed(test::ball(12), 1e-3, {0, 0, 1e-2});
  const std::size_t of_ball = triangles.size();
  const auto ground = test::placed(test::sheet(20), side, {-0.5 * side, -0.5 * side, 0});
  triangles.insert(triangles.end(), ground.begin(), ground.end());
  TileMesh mesh = test::tile_of(triangles);
  test::decimate(mesh, cost, of_ball + 2);
  const auto left = test::live_triangles(mesh);
  CHECK(left.size() == of_ball + 2);
  CHECK(std::count_if(left.begin(), left.end(), [](const Triangle& t) { return t[0][2] > 0; }) ==
        static_cast<std::ptrdiff_t>(of_ball));
}

}  // namespace winnow
