// Records in any order are those of the spool, and those near each other are read once.
#include "io/recent_blocks.hpp"

#include "support/job.hpp"
#include "support/random.hpp"
#include "support/scratch_files.hpp"
#include "support/sources.hpp"

#include <catch2/catch.hpp>

namespace winnow {

TEST_CASE("records come from memory and from scratch, whatever their size and the order") {
  test::Random random(75);
  for (const std::size_t record : {std::size_t{1}, std::size_t{4}, std::size_t{48},
                                   std::size_t{100}, std::size_t{12'288}, std::size_t{20'000}}) {
    const std::size_t count = 2'000'000 / record + 1;
    const std::string content = random.bytes(count * record);
    for (const std::uint64_t limit : {std::uint64_t{0}, std::uint64_t{64} << 20}) {
      test::TestJob test;
      Spool spool(test.job, limit);
      spool.append(test::bytes_of(content));
      spool.finish();
      REQUIRE(spool.in_memory() == (limit > 0));
      RecentBlocks blocks(spool, record);
      CAPTURE(record, limit);
      std::uint64_t near = 0;
      for (int i = 0; i < 3000; ++i) {
        near = random.chance(0.1) ? random.below(count) : (near + random.below(3)) % count;
        REQUIRE(test::text_of(blocks.record(near)) == content.substr(near * record, record));
      }
      REQUIRE(test::text_of(blocks.record(count - 1)) == content.substr((count - 1) * record));
    }
  }
}

TEST_CASE("a block that could not be read is not taken for one that was") {
  test::TestJob test;
  const std::set<int> before = test::descriptors();
  Spool spool(test.job, 0);
  const std::string content = test::Random(76).bytes(100'000);
  spool.append(test::bytes_of(content));
  spool.finish();
  const test::OpenedFile file(test::opened_since(before).front());
  RecentBlocks blocks(spool, 4);
  file.flip(10, 1);
  CHECK_THROWS_AS(blocks.record(0), Error);
  CHECK_THROWS_AS(blocks.record(0), Error);
  file.flip(10, 1);
  CHECK(test::text_of(blocks.record(0)) == content.substr(0, 4));
}

}  // namespace winnow
