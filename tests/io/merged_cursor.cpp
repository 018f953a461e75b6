// Many sorted sources read as one.
#include "io/sorted_runs.hpp"
#include "support/random.hpp"

#include <algorithm>
#include <map>

#include <catch2/catch.hpp>

namespace winnow {

namespace {

// Adds up below a bound, as cells and faces do.
struct Tally {
  std::uint64_t key = 0;
  std::uint64_t count = 0;
  static constexpr std::uint64_t bound = 100;
  static bool before(const Tally& a, const Tally& b) { return a.key < b.key; }
  static bool combine(Tally& into, const Tally& from) {
    if (into.count + from.count >= bound) return false;
    into.count += from.count;
    return true;
  }
};

// Never adds up: the order can be compared with that of std::sort.
struct Plain {
  std::uint64_t key = 0;
  static bool before(const Plain& a, const Plain& b) { return a.key < b.key; }
  static bool combine(Plain& /*into*/, const Plain& /*from*/) { return false; }
};

template <typename Record>
std::vector<Record> merged(std::vector<std::vector<Record>>& sources) {
  std::vector<std::unique_ptr<RecordCursor<Record>>> cursors;
  for (std::vector<Record>& source : sources) {
    std::sort(source.begin(), source.end(), Record::before);
    cursors.push_back(std::make_unique<MemoryCursor<Record>>(source));
  }
  MergedCursor<Record> all(std::move(cursors));
  std::vector<Record> out;
  for (Record record; all.next(record);) out.push_back(record);
  Record record{};
  CHECK_FALSE(all.next(record));  // and stays at the end
  return out;
}

}  // namespace

TEST_CASE("merged sources come in the order of sorting everything") {
  test::Random random(20);
  for (int round = 0; round < 200; ++round) {
    std::vector<std::vector<Plain>> sources(random.between(0, 40));
    std::vector<std::uint64_t> all;
    const std::uint64_t keys = random.one_of<std::uint64_t>({1, 5, 1000, UINT64_MAX});
    for (std::vector<Plain>& source : sources) {
      source.resize(random.chance(0.2) ? 0 : random.between(1, 60));
      for (Plain& record : source) {
        record.key = random.below(keys);
        all.push_back(record.key);
      }
    }
    std::sort(all.begin(), all.end());
    std::vector<std::uint64_t> got;
    for (const Plain& record : merged(sources)) got.push_back(record.key);
    CAPTURE(round);
    REQUIRE(got == all);
  }
}

TEST_CASE("merged records of one key are added up as far as they allow") {
  test::Random random(21);
  for (int round = 0; round < 200; ++round) {
    std::vector<std::vector<Tally>> sources(random.between(1, 20));
    std::map<std::uint64_t, std::uint64_t> sums;
    // Small counts of a key never reach the bound, large ones do at once.
    const std::uint64_t most = random.chance(0.5) ? 2 : Tally::bound - 1;
    for (std::vector<Tally>& source : sources) {
      source.resize(random.below(40));
      for (Tally& record : source) {
        record = {random.below(200), random.between(1, most)};
        sums[record.key] += record.count;
      }
    }
    std::uint64_t last = 0;
    std::map<std::uint64_t, std::uint64_t> got;
    std::map<std::uint64_t, int> times;
    for (const Tally& record : merged(sources)) {
      REQUIRE(record.key >= last);
      REQUIRE(record.count < Tally::bound);
      last = record.key;
      got[record.key] += record.count;
      ++times[record.key];
    }
    REQUIRE(got == sums);
    for (const auto& [key, sum] : sums) {
      if (sum < Tally::bound) REQUIRE(times[key] == 1);
    }
  }
}

}  // namespace winnow
