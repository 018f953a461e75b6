// Parts of records give what sorting all of them gives.
#include "io/parted_records.hpp"

#include "io/arena.hpp"
#include "support/job.hpp"
#include "support/random.hpp"

#include <algorithm>
#include <vector>

#include <catch2/catch.hpp>

namespace winnow {

using namespace test;

namespace {

struct Ranked {
  std::uint64_t high;
  std::uint64_t low;

  [[nodiscard]] std::uint64_t rank() const { return high; }
  static bool before(const Ranked& a, const Ranked& b) {
    return a.high != b.high ? a.high < b.high : a.low < b.low;
  }
  static bool combine(Ranked& /*into*/, const Ranked& /*from*/) { return false; }
  bool operator==(const Ranked&) const = default;
};

std::vector<Ranked> by_parts(const std::vector<Ranked>& records, std::uint64_t most,
                             unsigned threads, std::uint64_t memory) {
  TestJob test({.threads = threads});
  std::vector<Ranked> sorted;
  in_arena(test.job, [&] {
    const PartsPlan plan =
        PartedRecords<Ranked>::plan(memory, threads, records.size(), sizeof(Ranked));
    PartedRecords<Ranked> parted(test.job, plan);
    constexpr std::size_t stretch = 1000;
    parallel_for(records.size() / stretch, [&](std::size_t i) {
      for (std::size_t k = i * stretch; k < (i + 1) * stretch; ++k)
        parted.local().add(records[k].high / (most / plan.parts + 1), records[k]);
    });
    parted.for_each_stretch<std::vector<Ranked>>(
        [](std::span<const Ranked> in, std::vector<Ranked>& out) {
          out.assign(in.begin(), in.end());
        },
        [&](const std::vector<Ranked>& out) {
          sorted.insert(sorted.end(), out.begin(), out.end());
        });
  });
  return sorted;
}

}  // namespace

TEST_CASE("records by parts are in the order of all of them in any memory and threads") {
  Random random(77);
  for (const std::uint64_t ranks :
       {std::uint64_t{1}, std::uint64_t{1000}, std::uint64_t{1} << 62}) {
    std::vector<Ranked> records(300'000);
    // Half of them in one part.
    for (Ranked& record : records) {
      const std::uint64_t high = random.below(ranks);
      record = {random.chance(0.5) ? high / 100'000 : high, random.below(1000)};
    }
    std::vector<Ranked> right = records;
    std::sort(right.begin(), right.end(), Ranked::before);
    for (const unsigned threads : {1U, 3U}) {
      for (const std::uint64_t memory : {std::uint64_t{1} << 20, std::uint64_t{1} << 26}) {
        CAPTURE(ranks, threads, memory);
        CHECK((by_parts(records, ranks, threads, memory) == right));
      }
    }
  }
}

}  // namespace winnow
