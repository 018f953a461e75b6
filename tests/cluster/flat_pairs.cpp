// Opposite faces without area are dropped, so that no edge of a closed mesh gets four faces.
#include "support/refining.hpp"

#include <cmath>

#include <catch2/catch.hpp>

namespace winnow {

using namespace test;

namespace {

// A cube of which each side is a fan over n points an edge, so that at its edges faces without area
// lie upon each other; turned about two axes.
std::vector<Triangle> capped_cube(std::size_t n, double angle) {
  const auto ring = [&](std::size_t i) -> std::array<double, 2> {
    const double up = static_cast<double>(i % n) / static_cast<double>(n);
    const double down = static_cast<double>(n - i % n) / static_cast<double>(n);
    const std::array<std::array<double, 2>, 4> sides{{{up, 0}, {1, up}, {down, 1}, {0, down}}};
    return sides[i / n % 4];
  };
  const double c = std::cos(angle);
  const double s = std::sin(angle);
  const auto turn = [&](const Point& p) -> Point {
    const Point q{c * p[0] - s * p[1], s * p[0] + c * p[1], p[2]};
    return {q[0], c * q[1] - s * q[2], s * q[1] + c * q[2]};
  };
  std::vector<Triangle> faces;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    for (const bool high : {false, true}) {
      const auto at = [&](std::size_t i) {
        Point p{};
        p[axis] = high ? 1 : 0;
        p[(axis + 1) % 3] = ring(i)[0];
        p[(axis + 2) % 3] = ring(i)[1];
        return turn(p);
      };
      for (std::size_t i = 1; i + 1 < 4 * n; ++i) {
        const Triangle face{at(0), at(i), at(i + 1)};
        faces.push_back(high ? face : turned(face));
      }
    }
  }
  return faces;
}

}  // namespace

TEST_CASE("faces without area that lie upon each other leave a closed mesh") {
  for (const double angle : {0.0, 0.4, 1.1}) {
    for (const std::size_t n : {2, 7, 40}) {
      CAPTURE(angle, n);
      TestJob test;
      const WeldResult result = weld(test.job, capped_cube(n, angle));
      CHECK(result.flat_pairs == 3 * (n - 1));
      CHECK(result.fused == 0);
      CHECK(result.mesh.face_count == 6 * (4 * n - 2) - 2 * result.flat_pairs);
      const Defects defects = defects_of(plain(result).faces);
      CHECK(defects.crowded == 0);
      CHECK(defects.boundary_edges == 0);
      CHECK(defects.discords == 0);
    }
  }
}

TEST_CASE("faces without area are left out by pairs alone, and those with area never") {
  const Triangle flat{{{0, 0, 0}, {1, 1, 1}, {3, 3, 3}}};
  const Triangle small{{{0, 0, 0}, {1e-3, 0, 0}, {0, 1e-3, 0}}};
  struct Case {
    Triangle face;
    int along, against;
    std::uint64_t left, flat_pairs, fused;
  };
  for (const auto& [face, along, against, left, flat_pairs, fused] : {Case{flat, 1, 0, 1, 0, 0},
                                                                      {flat, 1, 1, 0, 1, 0},
                                                                      {flat, 2, 2, 0, 2, 0},
                                                                      {flat, 2, 1, 1, 0, 1},
                                                                      {small, 1, 1, 1, 0, 1}}) {
    CAPTURE(along, against, left);
    std::vector<Triangle> faces = sheet(2, 10);
    const std::size_t others = faces.size();
    for (int i = 0; i < along; ++i) faces.push_back(face);
    for (int i = 0; i < against; ++i) faces.push_back(turned(face));
    TestJob test;
    const WeldResult result = weld(test.job, faces);
    CHECK(result.mesh.face_count == others + left);
    CHECK(result.flat_pairs == flat_pairs);
    CHECK(result.fused == fused);
  }
}

}  // namespace winnow
