// The running median against sorting.
#include "decimate/running_median.hpp"

#include "support/random.hpp"

#include <algorithm>
#include <map>
#include <set>
#include <vector>

#include <catch2/catch.hpp>

namespace winnow {

namespace {

// Values from a few to many, so that some are equal.
void compare_with_sorting(std::uint64_t seed, std::uint64_t values) {
  constexpr VertexNumber vertices = 60;
  test::Random random(seed);
  RunningMedian median(vertices);
  std::map<VertexNumber, double> numbers;
  std::set<VertexNumber> upper;
  for (int step = 0; step < 5000; ++step) {
    const auto v = static_cast<VertexNumber>(random.below(vertices));
    const auto crossed = [&](VertexNumber w) {
      if (!upper.erase(w)) upper.insert(w);
    };
    upper.erase(v);
    // Told of what becomes of the others; of `v` one asks.
    if (random.chance(0.4)) {
      median.erase(v, crossed);
      numbers.erase(v);
    } else {
      numbers[v] = static_cast<double>(random.below(values)) - 2;
      median.set(v, numbers[v], crossed);
    }
    upper.erase(v);
    if (median.in_upper_half(v)) upper.insert(v);

    REQUIRE(median.empty() == numbers.empty());
    if (numbers.empty()) continue;
    std::vector<double> sorted;
    for (const auto& [w, number] : numbers) sorted.push_back(number);
    std::sort(sorted.begin(), sorted.end());
    REQUIRE(median.median() == sorted[sorted.size() / 2]);
    REQUIRE(upper.size() == (sorted.size() + 1) / 2);
    for (VertexNumber w = 0; w < vertices; ++w) {
      REQUIRE(median.in_upper_half(w) == upper.contains(w));
      if (!upper.contains(w)) continue;
      REQUIRE(numbers.contains(w));
      REQUIRE(numbers[w] >= median.median());
    }
  }
}

}  // namespace

TEST_CASE("the upper half is the upper half, whatever comes, changes and goes") {
  compare_with_sorting(1, 1000000);
  compare_with_sorting(2, 7);
  compare_with_sorting(3, 1);
}

}  // namespace winnow
