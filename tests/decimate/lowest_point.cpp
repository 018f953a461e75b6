// Where a quadric is lowest, against elimination with pivots in more digits.
#include "base/quadric.hpp"
#include "support/random.hpp"

#include <array>
#include <cmath>
#include <utility>

#include <catch2/catch.hpp>

namespace winnow {

namespace {

// (A + pull) t = b + pull * rest.
std::array<long double, 3> by_elimination(const Quadric& q, double pull, const Point& rest) {
  std::array<std::array<long double, 4>, 3> row{{{q.xx, q.xy, q.xz, q.b[0]},  //
                                                 {q.xy, q.yy, q.yz, q.b[1]},
                                                 {q.xz, q.yz, q.zz, q.b[2]}}};
  for (std::size_t i = 0; i < 3; ++i) {
    row[i][i] += pull;
    row[i][3] += static_cast<long double>(pull) * rest[i];
  }
  for (std::size_t i = 0; i < 3; ++i) {
    std::size_t pivot = i;
    for (std::size_t k = i + 1; k < 3; ++k) {
      if (std::abs(row[k][i]) > std::abs(row[pivot][i])) pivot = k;
    }
    std::swap(row[i], row[pivot]);
    for (std::size_t k = 0; k < 3; ++k) {
      if (k == i) continue;
      const long double factor = row[k][i] / row[i][i];
      for (std::size_t j = i; j < 4; ++j) row[k][j] -= factor * row[i][j];
    }
  }
  return {row[0][3] / row[0][0], row[1][3] / row[1][1], row[2][3] / row[2][2]};
}

Point random_point(test::Random& random) {
  return {random.real(-1, 1), random.real(-1, 1), random.real(-1, 1)};
}

}  // namespace

TEST_CASE("the lowest point of a quadric is that of a dense solve") {
  test::Random random(830);
  for (const double unit : {1e-12, 1.0, 1e12}) {
    // One plane leaves two directions to the pull, two leave one.
    for (const int planes : {1, 2, 3, 20}) {
      for (int round = 0; round < 200; ++round) {
        Quadric q;
        for (int i = 0; i < planes; ++i) {
          const Point direction = random_point(random);
          const double size = length(direction);
          if (size < 0.1) continue;
          q.add_plane((1 / size) * direction, unit * random_point(random),
                      unit * unit * random.unit());
        }
        const Point rest = unit * random_point(random);
        for (const double pull : {1e-4, 1e-2}) {
          const double strength = pull * q.weight();
          if (strength == 0) continue;
          const Point found = lowest_point(q, strength, rest);
          const auto right = by_elimination(q, strength, rest);
          for (std::size_t axis = 0; axis < 3; ++axis) {
            // The pull bounds the condition by its inverse, and products of two rows square that.
            CHECK(std::abs(found[axis] - right[axis]) <= 1e-15 * unit / (pull * pull));
          }
        }
      }
    }
  }
}

TEST_CASE("planes that meet in a point pull a vertex there") {
  // With a hardly noticeable pull: three upright planes of one corner.
  Quadric q;
  const Point corner{3, -2, 7};
  q.add_plane({1, 0, 0}, corner, 2);
  q.add_plane({0, 1, 0}, corner, 1);
  q.add_plane({0, 0, 1}, corner, 5);
  const Point found = lowest_point(q, 1e-9, {0, 0, 0});
  for (std::size_t axis = 0; axis < 3; ++axis)
    CHECK(found[axis] == Approx(corner[axis]).epsilon(1e-7));
  CHECK(q.at(corner) == Approx(0).margin(1e-12));
  CHECK(q.from(corner).c == Approx(0).margin(1e-12));
}

}  // namespace winnow
