// A list is turned round the same in memory and by sorting, and only where it has each number once.
#include "io/inverse_numbers.hpp"

#include "support/job.hpp"
#include "support/random.hpp"

#include <numeric>
#include <utility>

#include <catch2/catch.hpp>

namespace winnow {

namespace {

constexpr std::uint32_t numbers = 100'000;
constexpr std::uint64_t little = mebibyte / 16;  // of which the list takes six times as much

std::vector<std::uint32_t> shuffled() {
  test::Random random(61);
  std::vector<std::uint32_t> list(numbers);
  std::iota(list.begin(), list.end(), 0U);
  for (std::uint32_t i = numbers; i > 1; --i) std::swap(list[i - 1], list[random.below(i)]);
  return list;
}

std::vector<std::uint32_t> inverse(const std::vector<std::uint32_t>& list, std::uint64_t memory) {
  test::TestJob test;
  InverseNumbers inverse(test.job, numbers, memory);
  for (const std::uint32_t number : list) inverse.add(number);
  Spool places(test.job, mebibyte);
  inverse.append_to(places);
  places.finish();
  return read_records<std::uint32_t>(places, 0, record_count<std::uint32_t>(places));
}

}  // namespace

TEST_CASE("a list of numbers is turned round in memory and in scratch") {
  const std::vector<std::uint32_t> list = shuffled();
  for (const std::uint64_t memory : {mebibyte, little}) {
    const std::vector<std::uint32_t> places = inverse(list, memory);
    REQUIRE(places.size() == numbers);
    for (std::uint32_t i = 0; i < numbers; ++i) REQUIRE(places[list[i]] == i);
  }
}

TEST_CASE("a list with a number twice, or without one, is not turned round") {
  std::vector<std::uint32_t> list = shuffled();
  list[1] = list[0];
  for (const std::uint64_t memory : {mebibyte, little})
    CHECK_THROWS_AS(inverse(list, memory), std::logic_error);
  list.pop_back();
  for (const std::uint64_t memory : {mebibyte, little})
    CHECK_THROWS_AS(inverse(list, memory), std::logic_error);
}

}  // namespace winnow
