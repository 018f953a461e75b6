// Sorted runs in scratch: nothing lost, everything in order, few files open.
#include "io/sorted_runs.hpp"

#include "support/job.hpp"
#include "support/random.hpp"

#include <algorithm>
#include <filesystem>
#include <map>
#include <thread>

#include <catch2/catch.hpp>

namespace winnow {

namespace {

struct Entry {
  std::uint64_t key = 0;
  std::uint64_t count = 0;
  std::uint64_t filling[3]{};  // of the size of real records
  static bool before(const Entry& a, const Entry& b) { return a.key < b.key; }
  static bool combine(Entry& into, const Entry& from) {
    into.count += from.count;
    return true;
  }
};

using Sums = std::map<std::uint64_t, std::uint64_t>;

std::size_t open_files() {
  const std::filesystem::directory_iterator all("/proc/self/fd");
  return static_cast<std::size_t>(std::distance(begin(all), end(all)));
}

void add_run(SortedRuns<Entry>& runs, std::vector<Entry> entries) {
  std::sort(entries.begin(), entries.end(), Entry::before);
  MemoryCursor<Entry> cursor(entries);
  runs.add(cursor);
}

std::vector<Entry> random_entries(test::Random& random, std::size_t count, std::uint64_t keys) {
  std::vector<Entry> entries(count);
  for (Entry& entry : entries) entry = {random.below(keys), random.between(1, 9), {1, 2, 3}};
  return entries;
}

std::size_t cursors_of(const SortedRuns<Entry>& runs) {
  std::vector<std::unique_ptr<RecordCursor<Entry>>> sources;
  runs.add_cursors(sources);
  return sources.size();
}

Sums read_back(const SortedRuns<Entry>& runs) {
  std::vector<std::unique_ptr<RecordCursor<Entry>>> sources;
  runs.add_cursors(sources);
  MergedCursor<Entry> merged(std::move(sources));
  Sums sums;
  for (Entry entry; merged.next(entry);) {
    if (!sums.empty()) REQUIRE(sums.rbegin()->first < entry.key);  // in order, and each key once
    REQUIRE(entry.filling[2] == 3);
    sums[entry.key] += entry.count;
  }
  return sums;
}

}  // namespace

TEST_CASE("runs come back merged, however many there are") {
  constexpr std::size_t fan_in = SortedRuns<Entry>::fan_in;
  // Beyond fan_in runs are merged into one of the next level, beyond fan_in squared into one of the
  // third.
  for (const std::size_t count :
       {std::size_t{1}, fan_in - 1, fan_in, fan_in + 1, 3 * fan_in + 5, fan_in * fan_in + 3}) {
    test::TestJob test;
    SortedRuns<Entry> runs(test.job);
    CHECK(runs.empty());
    test::Random random(count);
    Sums sums;
    const std::size_t before = open_files();
    for (std::size_t i = 0; i < count; ++i) {
      const std::vector<Entry> entries = random_entries(random, random.between(1, 30), 2000);
      for (const Entry& entry : entries) sums[entry.key] += entry.count;
      add_run(runs, entries);
    }
    CAPTURE(count);
    CHECK_FALSE(runs.empty());
    CHECK(open_files() - before == cursors_of(runs));
    CHECK(cursors_of(runs) <= 3 * (fan_in - 1));
    CHECK((cursors_of(runs) < count) == (count >= fan_in));
    CHECK(read_back(runs) == sums);
    CHECK(read_back(runs) == sums);  // reading takes nothing away
  }
}

TEST_CASE("runs of many blocks keep their order") {
  test::TestJob test;
  SortedRuns<Entry> runs(test.job);
  test::Random random(30);
  Sums sums;
  for (const std::size_t blocks : {1, 2, 7, 40}) {
    for (const std::size_t more : {std::size_t{0}, std::size_t{1}}) {
      const std::vector<Entry> entries =
          random_entries(random, blocks * SortedRuns<Entry>::block_records + more, UINT64_MAX);
      for (const Entry& entry : entries) sums[entry.key] += entry.count;
      add_run(runs, entries);
    }
  }
  CHECK(read_back(runs) == sums);
}

TEST_CASE("an empty run is a run") {
  test::TestJob test;
  SortedRuns<Entry> runs(test.job);
  add_run(runs, {});
  CHECK(read_back(runs).empty());
  add_run(runs, {{5, 1, {1, 2, 3}}});
  CHECK(read_back(runs) == Sums{{5, 1}});
}

TEST_CASE("threads add runs at once", "[threads]") {
  test::TestJob test;
  SortedRuns<Entry> runs(test.job);
  std::vector<Sums> sums(4);
  std::vector<std::thread> threads;
  for (std::size_t number = 0; number < sums.size(); ++number) {
    threads.emplace_back([&, number] {
      test::Random random(40 + number);
      for (int i = 0; i < 25; ++i) {
        const std::vector<Entry> entries = random_entries(random, 50, 3000);
        for (const Entry& entry : entries) sums[number][entry.key] += entry.count;
        add_run(runs, entries);
      }
    });
  }
  for (std::thread& thread : threads) thread.join();
  for (std::size_t number = 1; number < sums.size(); ++number) {
    for (const auto& [key, count] : sums[number]) sums[0][key] += count;
  }
  CHECK(read_back(runs) == sums[0]);
}

TEST_CASE("a cancelled run stops writing") {
  test::TestJob test;
  SortedRuns<Entry> runs(test.job);
  test::Random random(50);
  const std::vector<Entry> entries =
      random_entries(random, 100 * SortedRuns<Entry>::block_records, 10);
  test.context.cancel();
  CHECK(test::error_of([&] { add_run(runs, entries); }).kind() == ErrorKind::cancelled);
}

}  // namespace winnow
