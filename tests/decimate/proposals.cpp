// Every vertex proposes its cheapest edge, and the cheapest of these come first.
#include "decimate/proposals.hpp"

#include "support/surfaces.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include <catch2/catch.hpp>

namespace winnow {

TEST_CASE("vertices propose their cheapest edges, the cheapest come first") {
  test::Random random(77);
  constexpr VertexNumber count = 500;
  std::vector<VertexNumber> vertices(count);
  std::iota(vertices.begin(), vertices.end(), 0U);
  Proposals proposals(count);
  for (int round = 0; round < 20; ++round) {
    std::vector<double> least(count, std::numeric_limits<double>::infinity());
    for (VertexNumber v = 0; v < count; ++v) {
      proposals.clear(v);
      const std::uint64_t edges = random.below(4);
      for (std::uint64_t i = 0; i < edges; ++i) {
        EvaluatedEdge edge;
        edge.cost = random.below(10) == 0 ? 0 : std::pow(10, random.real(-250, 250));
        edge.high = v + 1;
        proposals.add(v, edge);
        least[v] = std::min(least[v], edge.cost);
      }
      REQUIRE(proposals.of(v).cost == least[v]);
    }
    const auto finite = [](double cost) { return std::isfinite(cost); };
    const std::size_t proposed = proposals.count(vertices);
    REQUIRE(proposed ==
            static_cast<std::size_t>(std::count_if(least.begin(), least.end(), finite)));
    const std::size_t wanted = 1 + random.below(2 * proposed);
    const auto [cheapest, bound] = proposals.cheapest(vertices, wanted, wanted, 2, 1);
    CHECK((cheapest.size() >= wanted || std::isinf(bound)));
    double highest = 0;
    for (const VertexNumber low : cheapest) {
      REQUIRE(least[low] < bound);
      REQUIRE(least[low] >= highest / 1.0626);
      highest = std::max(highest, least[low]);
    }
    const auto cheaper = [bound = bound](double cost) { return cost < bound; };
    CHECK(cheapest.size() ==
          static_cast<std::size_t>(std::count_if(least.begin(), least.end(), cheaper)));
  }
}

TEST_CASE("what costs far more than usual is not among the cheapest") {
  // Half of the vertices propose a flat edge, the others one that has a shape.
  constexpr VertexNumber count = 100;
  std::vector<VertexNumber> vertices(count);
  std::iota(vertices.begin(), vertices.end(), 0U);
  for (const double flat : {0.0, 1e-210, 1e-6}) {
    Proposals proposals(count);
    for (VertexNumber v = 0; v < count; ++v) {
      EvaluatedEdge edge;
      edge.cost = v % 2 == 0 ? flat : 1;
      edge.high = v + 1;
      proposals.add(v, edge);
    }
    REQUIRE(proposals.count(vertices) == count);
    const auto [cheapest, bound] = proposals.cheapest(vertices, 80, 30, 256, 1);
    CHECK(cheapest.size() == 50);
    CHECK(bound <= std::max(1e-300, 300 * flat));
  }
}

TEST_CASE("costs that are alike keep the order of the vertices") {
  // 16 classes are an octave: alike are those above 0.97, and the next above 0.48.
  const std::vector<double> costs{1.9, 0.3, 1.1, 0.49, 1.5, 0.26};
  std::vector<VertexNumber> vertices(costs.size());
  std::iota(vertices.begin(), vertices.end(), 0U);
  Proposals proposals(static_cast<VertexNumber>(costs.size()));
  for (const VertexNumber v : vertices) {
    EvaluatedEdge edge;
    edge.cost = costs[v];
    proposals.add(v, edge);
  }
  const std::size_t all = proposals.count(vertices);
  const auto [cheapest, bound] = proposals.cheapest(vertices, all, all, 2, 16);
  CHECK(std::vector(cheapest.begin(), cheapest.end()) ==
        std::vector<VertexNumber>{1, 5, 3, 0, 2, 4});
  CHECK(bound > 1.9);
}

}  // namespace winnow
