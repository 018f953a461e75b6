// What a vertex offers when edges turn out costlier than they seemed.
#include "decimate/collapser.hpp"

#include <catch2/catch.hpp>

namespace winnow {

namespace {

void check_offer(const Offers& offers, double cost, VertexNumber partner) {
  CHECK_FALSE(offers.stale(0));
  CHECK(offers.of(0).cost == cost);
  CHECK(offers.of(0).partner == partner);
}

Offers offering(const Candidate& candidate) {
  Offers offers(1);
  offers.append(0, candidate);
  offers.order();
  return offers;
}

}  // namespace

TEST_CASE("a postponed edge gets its turn between the others") {
  Offers offers = offering({1, 7});
  offers.postpone(0, {3, 7});
  offers.go_on(0, {2, 8});
  check_offer(offers, 2, 8);
  offers.go_on(0, {4, 9});
  check_offer(offers, 3, 7);
  offers.go_on(0, {4, 9});
  check_offer(offers, 4, 9);
  offers.go_on(0, {});
  CHECK(offers.empty());
}

TEST_CASE("an edge forgotten for a cheaper postponed one is looked at again when that is refused") {
  Offers offers = offering({1, 7});
  offers.postpone(0, {5, 7});
  offers.go_on(0, {2, 8});
  offers.postpone(0, {3, 8});
  offers.go_on(0, {});
  check_offer(offers, 3, 8);
  offers.go_on(0, {});
  REQUIRE(offers.stale(0));
  // The same again, but the second is refused at once.
  offers.set(0, {1, 7});
  offers.postpone(0, {5, 7});
  offers.go_on(0, {2, 8});
  offers.go_on(0, {});
  check_offer(offers, 5, 7);
  offers.go_on(0, {});
  CHECK(offers.empty());
}

}  // namespace winnow
