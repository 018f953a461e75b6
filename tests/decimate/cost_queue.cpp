// The queue agrees with a set of pairs, whatever is put into it.
#include "decimate/cost_queue.hpp"

#include "support/random.hpp"

#include <set>
#include <utility>

#include <catch2/catch.hpp>

namespace winnow {

TEST_CASE("a queue of costs orders as a set does, ties by number") {
  test::Random random(810);
  for (const std::uint64_t kinds : {std::uint64_t{2}, std::uint64_t{40}, std::uint64_t{1} << 40}) {
    for (const VertexNumber vertices : {1U, 2U, 5U, 6U, 300U}) {
      CAPTURE(kinds, vertices);
      CostQueue queue(vertices);
      std::set<std::pair<double, VertexNumber>> right;
      std::vector<double> cost(vertices, -1);  // -1: not in the queue
      for (VertexNumber v = 0; v < vertices; ++v) {
        if (random.chance(0.3)) continue;
        cost[v] = static_cast<double>(random.below(kinds));
        queue.append(v, cost[v]);
        right.emplace(cost[v], v);
      }
      queue.order();
      for (int step = 0; step < 3000; ++step) {
        const auto v = static_cast<VertexNumber>(random.below(vertices));
        if (cost[v] >= 0) right.erase({cost[v], v});
        if (random.chance(0.4)) {
          queue.remove(v);
          cost[v] = -1;
        } else {
          cost[v] = static_cast<double>(random.below(kinds));
          queue.set(v, cost[v]);
          right.emplace(cost[v], v);
        }
        REQUIRE(queue.holds(v) == (cost[v] >= 0));
        if (queue.holds(v)) REQUIRE(queue.cost(v) == cost[v]);
        REQUIRE(queue.empty() == right.empty());
        if (right.empty()) continue;
        REQUIRE(std::pair(queue.top().cost, queue.top().vertex) == *right.begin());
      }
      // All of it, in order.
      for (; !right.empty(); right.erase(right.begin())) {
        REQUIRE(std::pair(queue.top().cost, queue.top().vertex) == *right.begin());
        queue.remove(queue.top().vertex);
      }
      CHECK(queue.empty());
    }
  }
}

}  // namespace winnow
