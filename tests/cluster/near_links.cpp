// Points hang together where a chain of steps below the distance leads: by trying all pairs.
#include "cluster/near_links.hpp"

#include "support/job.hpp"
#include "support/random.hpp"

#include <cmath>
#include <map>
#include <numeric>
#include <set>
#include <vector>

#include <catch2/catch.hpp>

namespace winnow::test {

namespace {

using Lowest =
    std::map<std::uint64_t, std::uint64_t>;  // of each number that is not the lowest itself

Lowest by_all_pairs(const std::vector<NumberedPoint>& points, double distance) {
  std::vector<std::size_t> parent(points.size());
  std::iota(parent.begin(), parent.end(), std::size_t{0});
  const auto root = [&](std::size_t i) {
    while (parent[i] != i) i = parent[i];
    return i;
  };
  for (std::size_t i = 0; i < points.size(); ++i) {
    for (std::size_t k = 0; k < i; ++k) {
      if (!is_nearer(points[i].position, points[k].position, distance)) continue;
      const auto [low, high] = std::minmax({root(i), root(k)});
      parent[high] = low;
    }
  }
  Lowest lowest;
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (root(i) != i) lowest[points[i].number] = points[root(i)].number;
  }
  return lowest;
}

Lowest found(const std::vector<NumberedPoint>& points, double distance) {
  TestJob test;
  Lowest lowest;
  NearLinks near(distance, test.job.progress);
  near.find(points, [&](std::uint64_t first, std::uint64_t other) {
    CHECK(lowest.emplace(other, first).second);
  });
  return lowest;
}

std::vector<NumberedPoint> numbered(const std::vector<Point>& points) {
  std::vector<NumberedPoint> out;
  for (const Point& p : points) out.push_back({3 * out.size() + 5, p});
  return out;
}

}  // namespace

TEST_CASE("points hang together as all pairs say") {
  Random random(1604);
  std::size_t chains = 0;
  for (int run = 0; run < 300; ++run) {
    const std::size_t count = random.between(2, 300);
    const double distance = random.real(0.02, 0.4);
    const bool flat = random.chance(0.3);
    std::vector<Point> points;
    for (std::size_t i = 0; i < count; ++i) {
      Point p{random.unit(), random.unit(), flat ? 0.5 : random.unit()};
      // Clumps of points, so that some boxes are small, and steps of just the distance.
      if (!points.empty() && random.chance(0.5)) {
        p = random.one_of(points);
        p[random.below(3)] += random.chance(0.3) ? distance : random.real(-distance, distance) / 8;
      }
      points.push_back(p);
    }
    CAPTURE(run, count, distance);
    const std::vector<NumberedPoint> all = numbered(points);
    const Lowest lowest = found(all, distance);
    CHECK((lowest == by_all_pairs(all, distance)));
    chains += lowest.size();
  }
  CHECK(chains > 1000);
}

TEST_CASE("a distance counts as less only where it is less") {
  // A lattice whose step is the distance itself, to the bit.
  std::vector<Point> points;
  for (int i = 0; i < 1000; ++i)
    points.push_back({0.125 * (i % 10), 0.125 * (i / 10 % 10), 0.125 * (i / 100)});
  CHECK(found(numbered(points), 0.125).empty());
  CHECK(found(numbered(points), std::nextafter(0.125, 1)).size() == 999);
}

TEST_CASE("many points within one distance cost no more than a sort") {
  Random random(1605);
  std::vector<Point> points;
  // Two clouds just too far from each other, and a bridge that joins one of them to a third.
  for (int i = 0; i < 60'000; ++i) {
    const double x = i % 3 == 0 ? 0 : i % 3 == 1 ? 0.7 : 2.5;
    points.push_back({x + random.real(0, 0.1), random.real(0, 0.1), random.real(0, 0.1)});
  }
  points.push_back({1.55, 0.05, 0.05});
  const Lowest lowest = found(numbered(points), 1.0);
  CHECK(lowest.size() == points.size() - 1);
  CHECK(found(numbered(points), 0.55).size() == points.size() - 4);
}

}  // namespace winnow::test
