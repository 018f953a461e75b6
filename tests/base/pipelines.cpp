// Pipelines keep their order, keep to their number of items, and clean up after an exception.
#include <winnow/error.hpp>

#include "base/parallel.hpp"
#include "support/job.hpp"

#include <algorithm>
#include <atomic>
#include <numeric>
#include <vector>

#include <catch2/catch.hpp>

namespace winnow {

namespace {

// Counts how many of its kind there are, and are at work.
struct Item {
  static inline std::atomic<int> alive{0};
  Item() { ++alive; }
  ~Item() { --alive; }
  Item(const Item&) = delete;
  Item& operator=(const Item&) = delete;

  int number = 0;
  int squared = 0;
};

constexpr int count = 2000;

}  // namespace

TEST_CASE("parallel work does every number once", "[threads]") {
  for (const std::size_t numbers : {0, 1, 7, 10'000}) {
    std::vector<std::atomic<int>> times(numbers);
    parallel_for(numbers, [&](std::size_t i) { ++times[i]; });
    CHECK(std::all_of(times.begin(), times.end(), [](const auto& t) { return t == 1; }));
  }
}

TEST_CASE("a pipeline fills and finishes in order, with so many items and no more", "[threads]") {
  for (const std::size_t items : {1, 2, 9}) {
    int next = 0;
    std::atomic<int> most{0};
    std::vector<int> finished;
    pipeline<Item>(
        items,
        [&](Item& item) {
          item.number = next++;
          return item.number < count;
        },
        [&](Item& item) {
          item.squared = item.number * item.number;
          for (int seen = most;
               Item::alive > seen && !most.compare_exchange_weak(seen, Item::alive);) {
          }
        },
        [&](const Item& item) {
          // Nothing here is atomic: one at a time.
          if (item.squared == item.number * item.number) finished.push_back(item.number);
        });
    CAPTURE(items);
    std::vector<int> right(count);
    std::iota(right.begin(), right.end(), 0);
    CHECK(finished == right);
    CHECK(most <= static_cast<int>(items) + 1);
    CHECK(Item::alive == 0);
  }
}

TEST_CASE("a pipeline of two steps works on every item once", "[threads]") {
  int next = 0;
  std::atomic<long> sum{0};
  pipeline<Item>(
      4,
      [&](Item& item) {
        item.number = next++;
        return item.number < count;
      },
      [&](const Item& item) { sum += item.number; });
  CHECK(sum == long{count} * (count - 1) / 2);
  CHECK(Item::alive == 0);
}

TEST_CASE("what any step throws comes out, and no item stays", "[threads]") {
  for (int step = 0; step < 3; ++step) {
    const auto fail_at = [&](int here, int number) {
      if (here == step && number == 700) throw Error(ErrorKind::resources, "the disk is full");
    };
    int next = 0;
    std::atomic<int> finished{0};
    const Error error = test::error_of([&] {
      pipeline<Item>(
          5,
          [&](Item& item) {
            item.number = next++;
            fail_at(0, item.number);
            return item.number < count;
          },
          [&](Item& item) { fail_at(1, item.number); },
          [&](const Item& item) {
            fail_at(2, item.number);
            ++finished;
          });
    });
    CAPTURE(step);
    CHECK(error.kind() == ErrorKind::resources);
    CHECK(std::string(error.what()) == "the disk is full");
    CHECK(finished <= 700);
    CHECK(Item::alive == 0);
  }
}

}  // namespace winnow
