// The components of a graph: those that a union-find gives, in few rounds, in any memory.
#include "cluster/components.hpp"

#include "io/arena.hpp"
#include "support/job.hpp"
#include "support/random.hpp"

#include <numeric>
#include <utility>
#include <vector>

#include <catch2/catch.hpp>

namespace winnow::test {

namespace {

using Links = std::vector<std::pair<std::uint64_t, std::uint64_t>>;

struct Found {
  Links members;  // the lowest number of a component, and another
  std::uint64_t rounds = 0, spilled = 0;
};

Found components_of(const Links& links, std::uint64_t memory = 4 * mebibyte) {
  TestJob test;
  return in_arena(test.job, [&] {
    Components components(test.job, memory);
    for (const auto& [a, b] : links) components.link(a, b);
    Found found;
    components.finish([&](std::uint64_t first, std::uint64_t other) {
      found.members.emplace_back(first, other);
    });
    found.rounds = components.rounds();
    found.spilled = test.job.scratch.written();
    return found;
  });
}

Links by_union(const Links& links, std::size_t numbers) {
  std::vector<std::uint64_t> parent(numbers);
  std::iota(parent.begin(), parent.end(), std::uint64_t{0});
  const auto root = [&](std::uint64_t i) {
    while (parent[i] != i) i = parent[i] = parent[parent[i]];
    return i;
  };
  for (const auto& [a, b] : links) {
    const auto [low, high] = std::minmax({root(a), root(b)});
    parent[high] = low;
  }
  Links members;
  for (std::uint64_t i = 0; i < numbers; ++i) {
    if (root(i) != i) members.emplace_back(root(i), i);
  }
  std::sort(members.begin(), members.end());
  return members;
}

}  // namespace

TEST_CASE("components are those of a union-find") {
  Random random(77);
  for (int run = 0; run < 60; ++run) {
    const std::size_t numbers = random.between(2, 2000);
    Links links;
    const std::size_t count = random.below(2 * numbers);
    for (std::size_t i = 0; i < count; ++i) {
      const std::uint64_t a = random.below(numbers);
      const std::uint64_t b = random.chance(0.7) ? (a + 1) % numbers : random.below(numbers);
      if (a != b) links.emplace_back(a, b);
    }
    CAPTURE(run, numbers, count);
    CHECK((components_of(links).members == by_union(links, numbers)));
  }
  CHECK(components_of({}).members.empty());
}

TEST_CASE("the rounds for a chain grow with the logarithm of its length", "[slow][long]") {
  Random random(78);
  for (const std::size_t length : {1'000, 200'000}) {
    Links links;
    std::vector<std::uint64_t> order(length);
    std::iota(order.begin(), order.end(), std::uint64_t{0});
    for (const bool shuffled : {false, true}) {
      if (shuffled) random.shuffle(order);
      links.clear();
      for (std::size_t i = 1; i < length; ++i) links.emplace_back(order[i - 1], order[i]);
      const Found found = components_of(links);
      CAPTURE(length, shuffled);
      CHECK(found.members.size() == length - 1);
      CHECK(found.rounds <= 20);
    }
  }
}

TEST_CASE("components spill and stay the same", "[slow]") {
  Random random(79);
  Links links;
  for (int i = 0; i < 400'000; ++i)
    links.emplace_back(random.below(1'000'000), 1'000'000 + random.below(1'000'000));
  const Found small = components_of(links, mebibyte);
  const Found large = components_of(links, 64 * mebibyte);
  CHECK(small.spilled > mebibyte);
  CHECK(large.spilled == 0);
  CHECK((small.members == large.members));
}

}  // namespace winnow::test
