// The scattered order is a permutation, and scattered.
#include "generate/scatter.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include <catch2/catch.hpp>

namespace winnow {

TEST_CASE("every number comes once") {
  for (const std::uint64_t count : {1U, 2U, 3U, 5U, 8U, 9U, 1000U, 1024U, 1025U, 65537U}) {
    for (const std::uint64_t seed : {0U, 1U, 99U}) {
      CAPTURE(count, seed);
      const Scatter scatter(count, seed);
      std::vector<bool> seen(count);
      std::uint64_t distinct = 0;
      for (std::uint64_t k = 0; k < count; ++k) {
        const std::uint64_t place = scatter(k);
        REQUIRE(place < count);
        if (!seen[place]) ++distinct;
        seen[place] = true;
      }
      CHECK(distinct == count);
    }
  }
}

TEST_CASE("numbers side by side land far apart") {
  constexpr std::uint64_t count = 1'000'000;
  const Scatter scatter(count, 1);
  double sum = 0;
  for (std::uint64_t k = 0; k + 1 < count; ++k) {
    sum += std::abs(static_cast<double>(scatter(k)) - static_cast<double>(scatter(k + 1)));
  }
  CHECK(sum / (count - 1) / count == Approx(1.0 / 3).epsilon(0.01));  // as for independent numbers
}

TEST_CASE("counts beyond 32 bits are scattered, too") {
  constexpr std::uint64_t count = (std::uint64_t{1} << 40) + 12345;
  const Scatter scatter(count, 1);
  std::vector<std::uint64_t> places;
  for (std::uint64_t k = count - 1000; k < count; ++k) places.push_back(scatter(k));
  for (const std::uint64_t place : places) CHECK(place < count);
  std::sort(places.begin(), places.end());
  CHECK(std::unique(places.begin(), places.end()) == places.end());
  CHECK(places.front() < count / 50);
  CHECK(places.back() > count - count / 50);
}

}  // namespace winnow
