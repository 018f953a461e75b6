// What edges cost: the same bits from the kernels of every instruction set, and what the formulas
// say.
#include "base/quadric.hpp"
#include "decimate/edge_batch.hpp"
#include "support/runnable.hpp"
#include "support/surfaces.hpp"

#include <cmath>
#include <cstring>
#include <limits>
#include <memory>
#include <utility>
#include <vector>

#include <catch2/catch.hpp>

namespace winnow {

using namespace test;

namespace {

// Of some faces around a vertex; sometimes none, or such as cancel each other.
VertexPlanes some_planes(Random& random, double scale) {
  VertexPlanes planes;
  const auto faces = random.below(7);
  for (std::size_t i = 0; i < faces; ++i) {
    const Point n = unit({random.real(-1, 1), random.real(-1, 1), random.real(-1, 1)});
    const double area = scale * scale * random.real(0, 1);
    add(planes, n, area);
  }
  return planes;
}

Quadric quadric_of(const VertexPlanes& p) {
  return {p.xx, p.xy, p.xz, p.yy, p.yz, p.zz, {}, 0};
}

}  // namespace

TEST_CASE("edges have the same costs and places by every instruction set") {
  Random random(31);
  const auto kernels = runnable(WINNOW_KERNELS(edge_kernel));
  for (int round = 0; round < 3000; ++round) {
    const double scale = std::pow(10, random.real(-30, 30));
    auto given = std::make_unique<EdgeBatch>();
    const Point low{scale * random.real(-1, 1), scale * random.real(-1, 1),
                    scale * random.real(-1, 1)};
    set_low(*given, low, some_planes(random, scale));
    const std::size_t count = 1 + random.below(EdgeBatch::capacity);
    for (std::size_t i = 0; i < count; ++i) {
      Point high{scale * random.real(-1, 1), scale * random.real(-1, 1),
                 scale * random.real(-1, 1)};
      if (random.below(20) == 0) high = low;
      if (random.below(50) == 0) high[random.below(3)] = std::numeric_limits<double>::max();
      set_high(*given, i, high, some_planes(random, scale), random.below(5) == 0);
    }
    const bool single = random.below(2) == 0;
    const EdgeBatch before = *given;
    kernels[0].second(*given, count, single);
    for (const auto& [name, kernel] : kernels) {
      EdgeBatch other = before;
      kernel(other, count, single);
      CHECK(std::memcmp(other.cost, given->cost, count * sizeof(double)) == 0);
      for (std::size_t axis = 0; axis < 3; ++axis)
        CHECK(std::memcmp(other.position[axis], given->position[axis], count * sizeof(double)) ==
              0);
    }
  }
}

TEST_CASE("an edge goes to the lowest point of its planes, at the error there") {
  Random random(32);
  for (int round = 0; round < 300; ++round) {
    EdgeBatch batch{};
    const Point low{random.real(-1, 1), random.real(-1, 1), random.real(-1, 1)};
    const Point high{random.real(-1, 1), random.real(-1, 1), random.real(-1, 1)};
    const VertexPlanes low_planes = some_planes(random, 1);
    set_low(batch, low, low_planes);
    const VertexPlanes high_planes = some_planes(random, 1);
    set_high(batch, 0, high, high_planes, false);
    edge_kernel_baseline(batch, 1, false);

    const Quadric at_low = quadric_of(low_planes);
    const Quadric at_high = quadric_of(high_planes);
    const double weight = at_low.weight() + at_high.weight();
    const Point place = position_of(batch, 0);
    if (batch.flat_low[0] + batch.flat_high[0] != 0) {
      CHECK((place == low || place == high));
      continue;
    }
    // A short edge goes first, but length never counts more than what is lost.
    const auto cost = [&](const Point& at) {
      const double lost = at_low.at(at - low) + at_high.at(at - high);
      return lost + std::min(lost, 1e-6 * weight * dot(high - low, high - low));
    };
    CHECK(batch.cost[0] == Approx(cost(place)).margin(1e-14));
    if (weight == 0) continue;
    // No point around is lower by more than what the pull to the middle gives up.
    const Point middle = 0.5 * (low + high);
    const auto pulled = [&](const Point& at) {
      return at_low.at(at - low) + at_high.at(at - high) +
             1e-4 * weight * dot(at - middle, at - middle);
    };
    for (int i = 0; i < 20; ++i) {
      const Point beside =
          place + Point{random.real(-1, 1), random.real(-1, 1), random.real(-1, 1)};
      CHECK(pulled(beside) >= pulled(place) - 1e-12);
    }
  }
}

TEST_CASE("single precision gives places that floats have") {
  Random random(33);
  EdgeBatch batch{};
  set_low(batch, {431000.1, 0, 0}, some_planes(random, 1));
  set_high(batch, 0, {431000.3, 0.1, 0.7}, some_planes(random, 1), false);
  edge_kernel_baseline(batch, 1, true);
  for (const double x : position_of(batch, 0))
    CHECK(static_cast<double>(static_cast<float>(x)) == x);
}

namespace {

// Of a face with this normal.
VertexPlanes plane(const Point& normal, double weight = 1) {
  VertexPlanes planes;
  add(planes, unit(normal), weight);
  return planes;
}

EdgeBatch evaluated(const Point& low, const VertexPlanes& low_planes, const Point& high,
                    const VertexPlanes& high_planes, bool single, bool stays = false) {
  EdgeBatch batch{};
  set_low(batch, low, low_planes);
  set_high(batch, 0, high, high_planes, stays);
  edge_kernel_baseline(batch, 1, single);
  return batch;
}

}  // namespace

TEST_CASE("a collapse without error takes that end of the edge, to the bit") {
  // The lower end is on a straight crease, the other at a corner.
  VertexPlanes crease = plane({0, 0, 1});
  add(crease, plane({0, 1, 0}));
  VertexPlanes corner = crease;
  add(corner, plane({1, 0, 0}));
  const Point low{0.1, 0.3, 0.7};
  const Point high{0.2, 0.3, 0.7};
  const EdgeBatch to_corner = evaluated(low, crease, high, corner, true);
  CHECK(position_of(to_corner, 0) == high);
  const EdgeBatch back = evaluated(high, corner, low, crease, true);
  CHECK(position_of(back, 0) == high);
}

TEST_CASE("flat edges cost less than all that has a shape, whatever their size") {
  for (const double size : {1e-12, 1.0, 1e12}) {
    const EdgeBatch flat = evaluated({0, 0, 0}, plane({0, 0, 1}, size * size), {size, 0, 0},
                                     plane({0, 0, 1}, size * size), true);
    const EdgeBatch shaped = evaluated({0, 0, 0}, plane({0, 0, 1}, 1e-30), {1e-15, 0, 5e-16},
                                       plane({0, 0.01, 1}, 1e-30), true);
    CHECK(flat.cost[0] > 0);
    CHECK(flat.cost[0] < shaped.cost[0]);
  }
}

TEST_CASE("of flat edges the shorter one goes first") {
  const VertexPlanes flat = plane({0, 0, 1});
  CHECK(evaluated({0, 0, 0}, flat, {1, 0, 0}, flat, true).cost[0] <
        evaluated({0, 0, 0}, flat, {2, 0, 0}, flat, true).cost[0]);
  CHECK(evaluated({0, 0, 0}, {}, {1, 0, 0}, {}, true).cost[0] <
        evaluated({0, 0, 0}, {}, {2, 0, 0}, {}, true).cost[0]);
}

TEST_CASE("rounding of an axis far off does not make another axis flat") {
  // A step of 1 in height, five million away: floats are off by a half there, but not in height.
  const Point low{5e6, 5e6, 10};
  const Point high{5e6 + 30, 5e6, 11};
  const EdgeBatch batch = evaluated(low, plane({0, 0, 1}), high, plane({0, 0, 1}), true);
  CHECK(batch.flat_low[0] + batch.flat_high[0] == 0);
}

TEST_CASE("an end that stays takes the collapse, at the error there") {
  const Point low{0, 0, 0};
  const Point high{1, 0, 0.5};
  const EdgeBatch batch = evaluated(low, plane({0, 0, 1}), high, plane({0, 1, 0}), false, true);
  CHECK(position_of(batch, 0) == high);
  CHECK(batch.cost[0] == Approx(0.25).epsilon(1e-4));
}

}  // namespace winnow
