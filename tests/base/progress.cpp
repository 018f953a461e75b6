// Progress is told now and then, from one thread at a time, and carries the wish to stop.
#include "base/progress.hpp"

#include <winnow/error.hpp>

#include "support/job.hpp"

#include <algorithm>
#include <chrono>
#include <string>
#include <thread>
#include <vector>

#include <catch2/catch.hpp>

namespace winnow {

TEST_CASE("progress adds up and starts again with each stage", "[threads]") {
  Context context;
  std::vector<Progress> told;
  std::atomic<int> at_once{0};
  std::atomic<bool> overlapped{false};
  std::atomic<int> times{0};
  context.progress = [&](const Progress& progress) {
    if (++at_once > 1) overlapped = true;
    told.push_back(progress);
    ++times;
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
    --at_once;
  };
  ProgressMeter meter(context);
  meter.begin("first", 1000, "faces");
  std::vector<std::thread> threads;
  const Stopwatch watch;
  for (int i = 0; i < 3; ++i) {
    threads.emplace_back([&] {
      // Longer where the machine has no time for it.
      while (watch.seconds() < 0.35 || (times < 2 && watch.seconds() < 20)) meter.advance(1);
    });
  }
  for (std::thread& thread : threads) thread.join();
  meter.begin("second", 7, "bytes");

  CHECK_FALSE(overlapped);
  REQUIRE(told.size() >= 3);  // the two beginnings, and about ten a second
  CHECK(told.size() <= 7);
  CHECK(std::string(told.front().stage) == "first");
  CHECK(told.front().done == 0);
  CHECK(told.front().total == 1000);
  for (std::size_t i = 1; i + 1 < told.size(); ++i) CHECK(told[i].done > told[i - 1].done);
  CHECK(std::string(told.back().stage) == "second");
  CHECK(std::string(told.back().unit) == "bytes");
  CHECK(told.back().done == 0);
}

TEST_CASE("sorting stops in the middle") {
  Context context;
  const ProgressMeter meter(context);
  std::vector<int> numbers(100'000);
  for (std::size_t i = 0; i < numbers.size(); ++i)
    numbers[i] = static_cast<int>(i * 7919 % numbers.size());
  std::size_t compared = 0;
  const auto before = meter.cancellable([&](int a, int b) {
    if (++compared == 1000) context.cancel();
    return a < b;
  });
  CHECK(test::error_of([&] { std::sort(numbers.begin(), numbers.end(), before); }).kind() ==
        ErrorKind::cancelled);
  CHECK(compared == 1000);
}

TEST_CASE("a cancelled context stops whoever counts") {
  Context context;
  ProgressMeter meter(context);
  meter.begin("stage", 0, "faces");
  CHECK_NOTHROW(meter.advance(1));
  CHECK_NOTHROW(meter.check_cancelled());
  context.cancel();
  CHECK(test::error_of([&] { meter.advance(1); }).kind() == ErrorKind::cancelled);
  CHECK(test::error_of([&] { meter.check_cancelled(); }).kind() == ErrorKind::cancelled);
  CHECK(test::error_of([&] { meter.begin("next", 0, "faces"); }).kind() == ErrorKind::cancelled);
}

}  // namespace winnow
