// What tiles will be cut at, by those that are known.
#include "stitch/price_estimate.hpp"

#include <cmath>

#include <catch2/catch.hpp>

namespace winnow {

TEST_CASE("the price of a cut is estimated by the known tiles") {
  PriceEstimate estimate(0.5);
  for (int tile = 0; tile < 20; ++tile) {
    if (tile < 6) CHECK(std::isinf(estimate.price()));
    std::vector<CollapseLog::Price> prices;
    for (int i = 1; i <= 90; ++i)
      prices.push_back({tile * 1e-3 + i, static_cast<std::uint64_t>(i), 0});
    estimate.add(prices, 100);
    if (tile < 6) continue;
    // Half of the faces go at prices up to 50.
    CHECK(estimate.price() >= 50);
    CHECK(estimate.price() < 50 * 1.13);
  }
}

TEST_CASE("no price is estimated that known tiles do not reach") {
  PriceEstimate estimate(0.95);
  for (int tile = 0; tile < 20; ++tile) estimate.add({{1, 50, 0}}, 100);
  CHECK(std::isinf(estimate.price()));
}

}  // namespace winnow
