// What tiles will be cut at, by those that are known.
#include "stitch/cost_estimate.hpp"

#include <cmath>

#include <catch2/catch.hpp>

namespace winnow {

TEST_CASE("the cost of a cut is estimated by the known tiles") {
  CostEstimate estimate(0.5);
  for (std::uint64_t tile = 0; tile < 20; ++tile) {
    if (tile < CostEstimate::fewest_tiles) CHECK(std::isinf(estimate.cost()));
    std::vector<CollapseLog::Cost> costs;
    for (int i = 1; i <= 90; ++i)
      costs.push_back({static_cast<double>(tile) * 1e-3 + i, static_cast<std::uint32_t>(i), 0});
    estimate.add(costs, 100);
    if (tile < CostEstimate::fewest_tiles) continue;
    // Half of the faces go at costs up to 50.
    CHECK(estimate.cost() >= 50);
    CHECK(estimate.cost() < 50 * 1.13);
  }
}

TEST_CASE("no cost is estimated that known tiles do not reach") {
  CostEstimate estimate(0.95);
  for (int tile = 0; tile < 20; ++tile) estimate.add({{1, 50, 0}}, 100);
  CHECK(std::isinf(estimate.cost()));
}

}  // namespace winnow
