// Folds go, and what must stay stays.
#include "base/box.hpp"
#include "decimate/surroundings.hpp"
#include "decimate/unfold.hpp"
#include "support/random.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include <catch2/catch.hpp>

namespace winnow::test {

namespace {

// All faces that a box meets.
class Faces final : public ReferenceSurface {
 public:
  explicit Faces(std::vector<Triangle> faces) : faces_(std::move(faces)) {}

  std::vector<Triangle> faces_near(const Box& box) override {
    std::vector<Triangle> found;
    for (const Triangle& t : faces_) {
      bool meets = true;
      for (std::size_t axis = 0; axis < 3; ++axis) {
        const auto [low, high] = std::minmax({t[0][axis], t[1][axis], t[2][axis]});
        meets = meets && low <= box.high[axis] && box.low[axis] <= high;
      }
      if (meets) found.push_back(t);
    }
    return found;
  }

 private:
  std::vector<Triangle> faces_;
};

struct Sheet {
  std::vector<Point> positions;
  std::vector<FaceVertices> faces;

  [[nodiscard]] std::vector<Triangle> triangles() const {
    std::vector<Triangle> all;
    for (const FaceVertices& f : faces)
      all.push_back({positions[f[0]], positions[f[1]], positions[f[2]]});
    return all;
  }
};

// The unit square in 2 n^2 faces, hilly.
Sheet sheet(std::uint32_t n) {
  Sheet s;
  for (std::uint32_t y = 0; y <= n; ++y) {
    for (std::uint32_t x = 0; x <= n; ++x) {
      const Point p{double(x) / n, double(y) / n, 0};
      s.positions.push_back({p[0], p[1], 0.05 * p[0] * p[0] - 0.03 * p[0] * p[1]});
    }
  }
  for (std::uint32_t y = 0; y < n; ++y) {
    for (std::uint32_t x = 0; x < n; ++x) {
      const std::uint32_t a = y * (n + 1) + x;
      s.faces.push_back({a, a + 1, a + n + 2});
      s.faces.push_back({a, a + n + 2, a + n + 1});
    }
  }
  return s;
}

std::size_t upside_down(const Sheet& s) {
  const std::vector<Triangle> all = s.triangles();
  return static_cast<std::size_t>(std::count_if(
      all.begin(), all.end(), [](const Triangle& t) { return doubled_area(t)[2] < 0; }));
}

// Vertices inside of the sheet, no two near each other, pushed over an edge.
std::vector<VertexNumber> fold(Sheet& s, std::uint32_t n) {
  std::vector<VertexNumber> pushed;
  for (std::uint32_t y = 2; y + 2 < n; y += 4) {
    for (std::uint32_t x = 2; x + 2 < n; x += 4) {
      pushed.push_back(y * (n + 1) + x);
      s.positions[pushed.back()][0] += 1.3 / n;
    }
  }
  return pushed;
}

constexpr std::uint32_t fine = 80, coarse = 20;

Unfolded unfolded(Sheet& s, const std::vector<std::uint8_t>& locked, bool single = false) {
  Faces reference(sheet(fine).triangles());
  return unfold(s.positions, s.faces, locked, {single}, reference);
}

}  // namespace

TEST_CASE("a sheet that is pushed over itself lies flat again") {
  for (const bool single : {false, true}) {
    Sheet s = sheet(coarse);
    const std::vector<VertexNumber> pushed = fold(s, coarse);
    const std::size_t before = upside_down(s);
    REQUIRE(before >= pushed.size());
    const std::vector<Point> from = s.positions;
    const Unfolded done = unfolded(s, std::vector<std::uint8_t>(s.positions.size(), 0), single);
    CHECK(upside_down(s) == 0);
    CHECK(done.tried > 0);
    CHECK(std::is_sorted(done.moved.begin(), done.moved.end()));
    CHECK(std::adjacent_find(done.moved.begin(), done.moved.end()) == done.moved.end());
    for (VertexNumber v = 0; v < s.positions.size(); ++v) {
      const bool moved = std::binary_search(done.moved.begin(), done.moved.end(), v);
      if (!moved) CHECK(s.positions[v] == from[v]);
      if (!moved || !single) continue;
      for (const double x : s.positions[v]) CHECK(double{static_cast<float>(x)} == x);
    }
  }
}

TEST_CASE("a sheet without folds stays to the bit") {
  Sheet s = sheet(coarse);
  const std::vector<Point> from = s.positions;
  CHECK(unfolded(s, std::vector<std::uint8_t>(s.positions.size(), 0)).moved.empty());
  CHECK(s.positions == from);
}

TEST_CASE("vertices that are locked stay") {
  Sheet s = sheet(coarse);
  fold(s, coarse);
  std::vector<std::uint8_t> locked(s.positions.size(), 1);
  const std::vector<Point> from = s.positions;
  CHECK(unfolded(s, locked).moved.empty());
  CHECK(s.positions == from);
  // All but the ones on the left.
  for (VertexNumber v = 0; v < from.size(); ++v) locked[v] = from[v][0] > 0.5 ? 1 : 0;
  const Unfolded done = unfolded(s, locked);
  CHECK_FALSE(done.moved.empty());
  for (const VertexNumber v : done.moved) CHECK(locked[v] == 0);
}

TEST_CASE("vertices of a boundary stay, folded or not") {
  Sheet s = sheet(coarse);
  for (std::uint32_t x = 2; x + 2 < coarse; x += 4) s.positions[x][1] += 1.3 / coarse;
  REQUIRE(upside_down(s) > 0);
  const std::vector<Point> from = s.positions;
  const Unfolded done = unfolded(s, std::vector<std::uint8_t>(s.positions.size(), 0));
  for (const VertexNumber v : done.moved) CHECK(v > coarse);
  for (std::uint32_t x = 0; x <= coarse; ++x) CHECK(s.positions[x] == from[x]);
}

TEST_CASE("thoroughly, vertices of a boundary turn their faces over") {
  Sheet s = sheet(coarse);
  for (std::uint32_t x = 2; x + 2 < coarse; x += 4) s.positions[x][1] += 1.3 / coarse;
  REQUIRE(upside_down(s) > 0);
  Faces reference(sheet(fine).triangles());
  const std::vector<std::uint8_t> locked(s.positions.size(), 0);
  unfold(s.positions, s.faces, locked, {false, true}, reference);
  CHECK(upside_down(s) == 0);
}

TEST_CASE("thoroughly, a piece beside the wrong one of two sheets goes to the other") {
  // The lower sheet faces down. Flat as it is, the piece looks like any other.
  Sheet upper = sheet(fine);
  for (Point& p : upper.positions) p[2] = 0.02;
  Sheet lower = upper;
  for (Point& p : lower.positions) p[2] = 0;
  for (FaceVertices& face : lower.faces) std::swap(face[0], face[1]);
  std::vector<Triangle> both = upper.triangles();
  for (const Triangle& t : lower.triangles()) both.push_back(t);
  Faces reference(both);
  const Sheet piece{{{0.3, 0.3, 0.005}, {0.5, 0.3, 0.005}, {0.5, 0.5, 0.005}, {0.3, 0.5, 0.005}},
                    {{0, 1, 2}, {0, 2, 3}}};
  const std::vector<std::uint8_t> locked(4, 0);
  for (const Triangle& t : piece.triangles()) {
    Hints hints = no_hints;
    REQUIRE(Surroundings(reference, box_around(t), 1).flipped(t, hints));
  }
  Sheet askew_alone = piece;
  unfold(askew_alone.positions, piece.faces, locked, {false, false}, reference);
  CHECK(askew_alone.positions == piece.positions);
  Sheet all = piece;
  unfold(all.positions, piece.faces, locked, {false, true}, reference);
  for (const Triangle& t : all.triangles()) {
    Hints hints = no_hints;
    CHECK_FALSE(Surroundings(reference, box_around(t), 1).flipped(t, hints));
  }
}

TEST_CASE("vertices of an edge with three faces stay") {
  Sheet s = sheet(coarse);
  const std::vector<VertexNumber> pushed = fold(s, coarse);
  // A fin on an edge of each.
  for (const VertexNumber v : pushed) {
    const auto tip = static_cast<VertexNumber>(s.positions.size());
    s.positions.push_back(s.positions[v] + Point{0, 0, 0.2});
    s.faces.push_back({v, v + coarse + 1, tip});
  }
  const std::vector<Point> from = s.positions;
  unfolded(s, std::vector<std::uint8_t>(s.positions.size(), 0));
  for (const VertexNumber v : pushed) CHECK(s.positions[v] == from[v]);
}

TEST_CASE("what is tried grows with the faces around vertices, and not with their square") {
  // One vertex with many faces, all folded: it stays, and is not tried.
  Sheet s = sheet(coarse);
  const auto hub = static_cast<VertexNumber>(s.positions.size());
  s.positions.push_back({0.5, 0.5, -0.001});
  constexpr std::uint32_t spokes = 3000;
  for (std::uint32_t i = 0; i < spokes; ++i) {
    const double angle = -6.283185307179586 * i / spokes;
    s.positions.push_back({0.5 + 0.4 * std::cos(angle), 0.5 + 0.4 * std::sin(angle), -0.001});
    s.faces.push_back({hub, hub + 1 + i, hub + 1 + (i + 1) % spokes});
  }
  const Unfolded done = unfolded(s, std::vector<std::uint8_t>(s.positions.size(), 0));
  CHECK(std::binary_search(done.moved.begin(), done.moved.end(), hub) == false);
  CHECK(done.tried < 200 * s.faces.size());
}

}  // namespace winnow::test
