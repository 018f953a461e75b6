// The importance of vertices whose faces are known.
#include "decimate/importance_cost.hpp"

#include <cmath>
#include <vector>

#include <catch2/catch.hpp>

namespace winnow {

TEST_CASE("a flat vertex is of no importance") {
  CHECK(visual_importance(std::vector<Point>{{1, 0, 0}, {0, 2, 0}, {-1, -1, 0}}, true) == 0);
  CHECK(visual_importance(std::vector<Point>{{1, 0, 0}, {0, 2, 0}}, false) == 0);
}

TEST_CASE("the corner of a cube has three areas at right angles") {
  CHECK(visual_importance(std::vector<Point>{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, true) ==
        Approx(1 - 1 / std::sqrt(3.0)).epsilon(1e-14));
}

TEST_CASE("the edge of a cube has two") {
  CHECK(visual_importance(std::vector<Point>{{1, 0, 0}, {0, 1, 0}, {-1, 0, 0}, {0, 0, 1}}, true) ==
        Approx(1 - 1 / std::sqrt(2.0)).epsilon(1e-14));
}

TEST_CASE("two faces back to back cancel out") {
  CHECK(visual_importance(std::vector<Point>{{1, 0, 0}, {0, 1, 0}, {1, 0, 0}}, false) == 1);
}

}  // namespace winnow
