// Which corners brought a face farther from the original.
#include "fit/farther.hpp"

#include <utility>

#include <catch2/catch.hpp>

namespace winnow::test {

namespace {

// The plane z = 0, or nothing that is known.
class Ground final : public ReferenceSurface {
 public:
  bool known = true;
  std::vector<Triangle> faces_near(const Box&) override {
    if (!known) return {};
    return {{{{-9, -9, 0}, {9, -9, 0}, {9, 9, 0}}}, {{{-9, -9, 0}, {9, 9, 0}, {-9, 9, 0}}}};
  }
};

using Corners = std::array<bool, 3>;

}  // namespace

TEST_CASE("corners that come farther off than before and than the limit are told") {
  Ground ground;
  const Triangle flat{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}};
  const Triangle high{{{0, 0, 0.3}, {1, 0, 0}, {0, 1, 0}}};
  CHECK(farther_corners(ground, flat, high, 0.5) == Corners{false, false, false});
  CHECK(farther_corners(ground, flat, high, 0.2) == Corners{true, false, false});
  // Nearer than before is allowed, however far it is.
  CHECK(farther_corners(ground, high, flat, 0.2) == Corners{false, false, false});
  Triangle higher = high;
  higher[0][2] = 0.4;
  CHECK(farther_corners(ground, high, higher, 0.35) == Corners{true, false, false});
  CHECK(farther_corners(ground, higher, high, 0.28) == Corners{false, false, false});
  // So far off the reference is not known well enough to tell.
  CHECK(farther_corners(ground, higher, high, 0.2) == Corners{true, false, false});
}

TEST_CASE("a side that comes farther off tells both of its corners") {
  Ground ground;
  const Triangle from{{{0, 0, 0.3}, {1, 0, -0.3}, {0, 1, 0}}};
  const Triangle to{{{0, 0, 0.3}, {1, 0, 0.25}, {0, 1, 0}}};
  CHECK(farther_corners(ground, from, to, 0.26) == Corners{true, true, false});
}

TEST_CASE("where the original is not known no corner may move") {
  Ground ground;
  ground.known = false;
  const Triangle flat{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}};
  const Triangle high{{{0, 0, 0.3}, {1, 0, 0}, {0, 1, 0}}};
  CHECK(farther_corners(ground, flat, high, 0.5) == Corners{true, true, true});
}

}  // namespace winnow::test
