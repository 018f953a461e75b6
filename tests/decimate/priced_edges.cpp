// Every vertex proposes its cheapest edge, and the cheapest of these come first.
#include "decimate/priced_edges.hpp"

#include "support/surfaces.hpp"
#include "support/tile_meshes.hpp"

#include <cmath>
#include <map>

#include <catch2/catch.hpp>

namespace winnow {

TEST_CASE("vertices propose their cheapest edges, the cheapest come first") {
  test::Random random(77);
  const TileMesh mesh = test::tile_of(test::ball(12));
  PricedEdges edges(mesh.vertex_count());
  for (int round = 0; round < 20; ++round) {
    edges.clear();
    std::map<std::uint32_t, double> prices;
    std::map<VertexNumber, double> least;
    for (FaceNumber f = 0; f < mesh.face_count(); ++f) {
      for (std::uint32_t i = 0; i < 3; ++i) {
        const FaceEdge edge{f, i};
        const auto [low, high] = edge.ends(mesh);
        const double price = random.below(10) == 0 ? 0 : std::pow(10, random.real(-250, 250));
        prices[edge.number()] = price;
        edges.add(edge, low, price);
        const auto [at, added] = least.emplace(low, price);
        if (!added) at->second = std::min(at->second, price);
      }
    }
    REQUIRE(edges.propose() >= least.size());
    const std::size_t wanted = 1 + random.below(2 * least.size());
    const auto [cheapest, bound] = edges.cheapest(wanted);
    CHECK((cheapest.size() >= wanted || std::isinf(bound)));
    double highest = 0;
    for (const std::uint32_t number : cheapest) {
      const double price = prices.at(number);
      const VertexNumber low = FaceEdge::of(number).ends(mesh).first;
      REQUIRE(price < bound);
      REQUIRE(price <= least.at(low) * 1.00001);
      REQUIRE(price >= highest / 1.0626);
      highest = std::max(highest, price);
    }
    std::size_t cheaper = 0;
    for (const auto& [low, price] : least) cheaper += price < bound;
    CHECK(cheapest.size() >= cheaper);
  }
}

}  // namespace winnow
