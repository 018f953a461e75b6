// Up to a cost the same collapses are done, however far a run may go beyond it.
#include "support/surfaces.hpp"
#include "support/tile_meshes.hpp"

#include <cstddef>
#include <vector>

#include <catch2/catch.hpp>

namespace winnow {

using namespace test;

namespace {

// Pieces of many sizes, some open, in one another's way or not: the small ones go as a whole.
std::vector<Triangle> rings_and_plates(std::uint64_t seed) {
  Random random(seed);
  std::vector<Triangle> faces;
  for (std::size_t i = 0; i < 30; ++i) {
    const double size = 0.01 * std::exp2(5 * random.unit());
    const Point at{random.unit(), random.unit(), random.unit()};
    const std::vector<Triangle> piece =
        placed(torus(3 + random.below(8), 3 + random.below(4)), size, at);
    const std::size_t left_out = random.below(piece.size());
    faces.insert(faces.end(), piece.begin(),
                 piece.end() - static_cast<std::ptrdiff_t>(i % 3 == 0 ? left_out : 0));
  }
  return as_floats(faces);
}

std::vector<DoneCollapse> collapses(const std::vector<Triangle>& faces,
                                    const DecimationSettings& settings,
                                    const CollapseLimits& limits) {
  TileMesh mesh = tile_of(faces);
  std::vector<DoneCollapse> all;
  Decimation::make(mesh, {}, settings)->run(limits, [&](const DoneCollapse& done) {
    all.push_back(done);
  });
  return all;
}

}  // namespace

TEST_CASE("what is collapsed up to a cost does not hang on how far a run may go", "[long]") {
  DecimationSettings settings;
  settings.cost = GENERATE(from_range(costs()));
  settings.free_topology = GENERATE(false, true);
  const bool in_sweeps = GENERATE(false, true);
  CAPTURE(settings.cost, settings.free_topology, in_sweeps);
  CollapseLimits unlimited;
  if (in_sweeps) unlimited.sweeps_to = 0;
  for (std::uint64_t seed = 1; seed <= 5; ++seed) {
    const std::vector<Triangle> faces = rings_and_plates(seed);
    const std::vector<DoneCollapse> all = collapses(faces, settings, unlimited);
    REQUIRE(all.size() > 100);
    Random random(seed);
    for (int i = 0; i < 8; ++i) {
      CollapseLimits limits = unlimited;
      limits.cost = random.one_of(all).cost;
      const std::vector<DoneCollapse> some = collapses(faces, settings, limits);
      std::size_t same = 0;
      while (same < all.size() && all[same].cost <= limits.cost) ++same;
      REQUIRE(some.size() >= same);
      for (std::size_t k = 0; k < same; ++k) {
        REQUIRE(some[k].edge.kept == all[k].edge.kept);
        REQUIRE(some[k].edge.removed == all[k].edge.removed);
        REQUIRE(some[k].edge.position == all[k].edge.position);
        REQUIRE(some[k].cost == all[k].cost);
      }
      // No other is told to cost as little.
      for (std::size_t k = same; k < some.size(); ++k) REQUIRE(some[k].cost > limits.cost);
    }
  }
}

}  // namespace winnow
