// A budget is never exceeded, and gets back what was taken.
#include "base/budget.hpp"

#include <winnow/error.hpp>

#include "support/job.hpp"
#include "support/random.hpp"

#include <thread>
#include <vector>

#include <catch2/catch.hpp>

namespace winnow {

TEST_CASE("a budget gives to the last byte and refuses the next") {
  Budget budget(1000);
  const Reservation most = budget.try_reserve(999);
  REQUIRE(most);
  CHECK(most.bytes() == 999);
  CHECK(budget.left() == 1);
  CHECK_FALSE(budget.try_reserve(2));
  CHECK(budget.left() == 1);
  const Reservation last = budget.try_reserve(1);
  CHECK(last);
  CHECK(budget.used() == 1000);
  CHECK(budget.left() == 0);
  CHECK(budget.total() == 1000);
  CHECK_FALSE(budget.try_reserve(1));
}

TEST_CASE("a request near 2^64 is refused, not wrapped") {
  Budget budget(1000);
  const Reservation some = budget.try_reserve(10);
  for (const std::uint64_t bytes :
       {UINT64_MAX, UINT64_MAX - 9, UINT64_MAX - 1009, std::uint64_t{1} << 63}) {
    CHECK_FALSE(budget.try_reserve(bytes));
  }
  CHECK(budget.used() == 10);
}

TEST_CASE("a reservation gives its bytes back once") {
  Budget budget(1000);
  {
    Reservation first = budget.try_reserve(100);
    Reservation moved = std::move(first);
    CHECK_FALSE(first);
    CHECK(first.bytes() == 0);
    CHECK(moved.bytes() == 100);
    CHECK(budget.used() == 100);
    first.release();
    CHECK(budget.used() == 100);
    moved.release();
    moved.release();
    CHECK(budget.used() == 0);
    CHECK_FALSE(moved);
  }
  CHECK(budget.used() == 0);
  {
    Reservation kept = budget.try_reserve(300);
    kept = budget.try_reserve(50);
    CHECK(budget.used() == 50);
    kept = {};
    CHECK(budget.used() == 0);
  }
}

TEST_CASE("what the plan has made room for fails by naming itself and a budget that works") {
  for (const std::uint64_t held :
       {std::uint64_t{0}, std::uint64_t{3} << 20, (std::uint64_t{7} << 20) + 12345}) {
    const std::uint64_t wanted = (std::uint64_t{9} << 20) + 17;
    Budget budget(std::uint64_t{8} << 20);
    const Reservation first = budget.try_reserve(held);
    const Error error = test::error_of([&] { (void)budget.reserve(wanted, "the thing"); });
    const std::string message = error.what();
    CAPTURE(message);
    CHECK(error.kind() == ErrorKind::resources);
    CHECK(message.find("the thing") != std::string::npos);
    CHECK(budget.used() == held);
    const std::size_t at = message.find("`memory` ");
    REQUIRE(at != std::string::npos);
    Budget enough(std::stoull(message.substr(at + 9)) << 20);
    const Reservation again = enough.try_reserve(held);
    CHECK(enough.try_reserve(wanted));
  }
}

TEST_CASE("a budget that is named counts what the run will ask for besides") {
  Budget budget(std::uint64_t{8} << 20);
  budget.expect(std::uint64_t{30} << 20);
  const Reservation held = budget.try_reserve(std::uint64_t{5} << 20);
  const Error error =
      test::error_of([&] { (void)budget.reserve(std::uint64_t{4} << 20, "the thing"); });
  CHECK(std::string(error.what()).find("`memory` 39M") != std::string::npos);
  CHECK(budget.left() == std::uint64_t{3} << 20);  // expecting takes nothing
}

TEST_CASE("a budget that is named is enough although what the run holds grows with it") {
  const auto named_by = [](const std::function<std::uint64_t(std::uint64_t)>& held) {
    Budget budget(8 * mebibyte);
    budget.expect_held(held);
    const Reservation now = budget.try_reserve(held(budget.total()));
    const Error error = test::error_of([&] { (void)budget.reserve(4 * mebibyte, "the thing"); });
    const std::string message = error.what();
    const std::size_t at = message.find("`memory` ");
    REQUIRE(at != std::string::npos);
    const std::uint64_t named = std::stoull(message.substr(at + 9));
    CHECK(held(named * mebibyte) + 4 * mebibyte <= named * mebibyte);
    return named;
  };
  // A share of the budget, and what does not grow.
  CHECK(named_by([](std::uint64_t total) { return total / 2 + 3 * mebibyte; }) == 14);
  CHECK(named_by([](std::uint64_t total) { return total / 10 * 9; }) == 40);
  // Something that is held in memory as soon as it fits, and much of which fits at once.
  CHECK(named_by([](std::uint64_t total) {
          return total < 9 * mebibyte ? 5 * mebibyte : 8 * mebibyte;
        }) == 12);
  // Nothing of the kind any more.
  Budget budget(8 * mebibyte);
  budget.expect_held([](std::uint64_t) { return 100 * mebibyte; });
  budget.expect_held({});
  const Error error = test::error_of([&] { (void)budget.reserve(9 * mebibyte, "the thing"); });
  CHECK(std::string(error.what()).find("`memory` 9M") != std::string::npos);
}

TEST_CASE("threads together never hold more than the budget", "[threads]") {
  constexpr std::uint64_t total = 10000;
  Budget budget(total);
  std::atomic<std::uint64_t> held{0};
  std::atomic<std::uint64_t> refused{0};
  std::atomic<bool> exceeded{false};
  std::vector<std::thread> threads;
  for (std::uint64_t number = 0; number < 4; ++number) {
    threads.emplace_back([&, number] {
      test::Random random(number);
      std::vector<Reservation> mine;
      for (int i = 0; i < 20000; ++i) {
        if (!mine.empty() && random.chance(0.5)) {
          held -= mine.back().bytes();
          mine.pop_back();
          continue;
        }
        Reservation reservation = budget.try_reserve(random.between(1, 2000));
        if (!reservation) {
          ++refused;
          continue;
        }
        // Counted after it was taken and uncounted before it is given back: never more than is
        // really held.
        if ((held += reservation.bytes()) > total) exceeded = true;
        mine.push_back(std::move(reservation));
      }
      for (const Reservation& reservation : mine) held -= reservation.bytes();
    });
  }
  for (std::thread& thread : threads) thread.join();
  CHECK_FALSE(exceeded);
  CHECK(refused > 0);
  CHECK(budget.used() == 0);
}

}  // namespace winnow
