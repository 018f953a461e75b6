// A border costs what it turns at the vertex that goes.
#include "decimate/importance_cost.hpp"

#include <catch2/catch.hpp>

namespace winnow {

TEST_CASE("a straight border turns by nothing, a right angle by 1, one that goes back by 2") {
  CHECK(border_turn({1, 0, 0}, {-1, 0, 0}) == 0);
  CHECK(border_turn({3, 0, 0}, {0, 0, 0.25}) == 1);
  CHECK(border_turn({0, 1, 0}, {0, 5, 0}) == 2);
}

TEST_CASE("the sharper a border turns, the more") {
  double last = 0;
  for (const Point& after :
       {Point{-2, 1, 0}, Point{-1, 1, 0}, Point{0, 1, 0}, Point{1, 1, 0}, Point{2, 1, 0}}) {
    const double turn = border_turn({1, 0, 0}, after);
    CHECK(turn > last);
    last = turn;
  }
}

}  // namespace winnow
