// Which corners brought a face farther from the original, or the original from it.
#include "fit/farther.hpp"

#include <utility>
#include <vector>

#include <catch2/catch.hpp>

namespace winnow::test {

namespace {

// The plane z = 0, a thorn that rises from it, or nothing that is known.
class Ground final : public ReferenceSurface {
 public:
  bool known = true;
  double thorn = 0;  // its height
  std::vector<Triangle> faces_near(const Box&) override {
    if (!known) return {};
    std::vector<Triangle> faces{{{{-9, -9, 0}, {9, -9, 0}, {9, 9, 0}}},
                                {{{-9, -9, 0}, {9, 9, 0}, {-9, 9, 0}}}};
    if (thorn > 0) faces.push_back({{{0.2, 0.2, 0}, {0.21, 0.2, 0}, {0.2, 0.2, thorn}}});
    return faces;
  }
};

using Corners = std::array<bool, 3>;

// Of a face with no others around it.
Corners farther(ReferenceSurface& reference, const Triangle& before, const Triangle& after,
                double far) {
  return farther_corners(reference, {&before, 1}, {&after, 1}, far);
}

}  // namespace

TEST_CASE("corners that come farther off than before and than the limit are told") {
  Ground ground;
  const Triangle flat{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}};
  const Triangle high{{{0, 0, 0.3}, {1, 0, 0}, {0, 1, 0}}};
  CHECK(farther(ground, flat, high, 0.5) == Corners{false, false, false});
  CHECK(farther(ground, flat, high, 0.2) == Corners{true, false, false});
  // Nearer than before is allowed, however far it is.
  CHECK(farther(ground, high, flat, 0.2) == Corners{false, false, false});
  Triangle higher = high;
  higher[0][2] = 0.4;
  CHECK(farther(ground, high, higher, 0.35) == Corners{true, false, false});
  CHECK(farther(ground, higher, high, 0.28) == Corners{false, false, false});
  // So far off the reference is not known well enough to tell.
  CHECK(farther(ground, higher, high, 0.2) == Corners{true, false, false});
}

TEST_CASE("a side that comes farther off tells both of its corners") {
  Ground ground;
  const Triangle from{{{0, 0, 0.3}, {1, 0, -0.3}, {0, 1, 0}}};
  const Triangle to{{{0, 0, 0.3}, {1, 0, 0.25}, {0, 1, 0}}};
  CHECK(farther(ground, from, to, 0.26) == Corners{true, true, false});
}

TEST_CASE("a face may not leave a vertex of the original farther behind") {
  Ground ground;
  ground.thorn = 0.2;
  const Triangle high{{{0, 0, 0.1}, {1, 0, 0.1}, {0, 1, 0.1}}};
  const Triangle flat{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}};
  CHECK(farther(ground, high, flat, 0.15) == Corners{true, true, true});
  CHECK(farther(ground, high, flat, 0.25) == Corners{false, false, false});
  CHECK(farther(ground, flat, high, 0.15) == Corners{false, false, false});
  // Where another face is as near as before, it is of no concern.
  const Triangle roof{{{0, 0, 0.25}, {1, 0, 0.25}, {0, 1, 0.25}}};
  const std::vector<Triangle> from{high, roof};
  const std::vector<Triangle> to{flat, roof};
  CHECK(farther_corners(ground, from, to, 0.15) == Corners{false, false, false});
}

TEST_CASE("where the original is not known no corner may move") {
  Ground ground;
  ground.known = false;
  const Triangle flat{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}};
  const Triangle high{{{0, 0, 0.3}, {1, 0, 0}, {0, 1, 0}}};
  CHECK(farther(ground, flat, high, 0.5) == Corners{true, true, true});
}

}  // namespace winnow::test
