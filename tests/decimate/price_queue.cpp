// The queue agrees with a set of pairs, whatever is put into it.
#include "decimate/price_queue.hpp"

#include "support/random.hpp"

#include <set>
#include <utility>

#include <catch2/catch.hpp>

namespace winnow {

TEST_CASE("a queue of prices orders as a set does, ties by number") {
  test::Random random(810);
  for (const std::uint64_t kinds : {std::uint64_t{2}, std::uint64_t{40}, std::uint64_t{1} << 40}) {
    for (const VertexNumber vertices : {1U, 2U, 5U, 6U, 300U}) {
      CAPTURE(kinds, vertices);
      PriceQueue queue(vertices);
      std::set<std::pair<double, VertexNumber>> right;
      std::vector<double> price(vertices, -1);  // -1: not in the queue
      for (VertexNumber v = 0; v < vertices; ++v) {
        if (random.chance(0.3)) continue;
        price[v] = static_cast<double>(random.below(kinds));
        queue.append(v, price[v]);
        right.emplace(price[v], v);
      }
      queue.order();
      for (int step = 0; step < 3000; ++step) {
        const auto v = static_cast<VertexNumber>(random.below(vertices));
        if (price[v] >= 0) right.erase({price[v], v});
        if (random.chance(0.4)) {
          queue.remove(v);
          price[v] = -1;
        } else {
          price[v] = static_cast<double>(random.below(kinds));
          queue.set(v, price[v]);
          right.emplace(price[v], v);
        }
        REQUIRE(queue.holds(v) == (price[v] >= 0));
        if (queue.holds(v)) REQUIRE(queue.price(v) == price[v]);
        REQUIRE(queue.empty() == right.empty());
        if (right.empty()) continue;
        REQUIRE(std::pair(queue.top().price, queue.top().vertex) == *right.begin());
      }
      // All of it, in order.
      for (; !right.empty(); right.erase(right.begin())) {
        REQUIRE(std::pair(queue.top().price, queue.top().vertex) == *right.begin());
        queue.remove(queue.top().vertex);
      }
      CHECK(queue.empty());
    }
  }
}

}  // namespace winnow
