// A mesh that is 1024 times as large has the same edges collapsed.
#include "support/surfaces.hpp"
#include "support/tile_meshes.hpp"

#include <catch2/catch.hpp>

namespace winnow {

TEST_CASE("the unit of length changes nothing by any cost") {
  const Refine cost = GENERATE(from_range(test::costs()));
  const auto triangles = GENERATE(test::ball(14, 0.2), test::sheet(12), test::cube(5));
  CAPTURE(cost);
  TileMesh mesh = test::tile_of(triangles);
  TileMesh large = test::tile_of(triangles, 1024);
  const auto log = test::decimate(mesh, cost, 30);
  const auto log_of_large = test::decimate(large, cost, 30);
  REQUIRE(log.size() > 50);
  REQUIRE(log.size() == log_of_large.size());
  for (std::size_t i = 0; i < log.size(); ++i) {
    REQUIRE(log[i].edge.kept == log_of_large[i].edge.kept);
    REQUIRE(log[i].edge.removed == log_of_large[i].edge.removed);
    REQUIRE(log_of_large[i].edge.position == 1024 * log[i].edge.position);
  }
}

}  // namespace winnow
