// The same bytes whether they stay in memory or move to scratch.
#include "io/spool.hpp"

#include "support/job.hpp"
#include "support/random.hpp"
#include "support/sanitized.hpp"
#include "support/sources.hpp"

#include <catch2/catch.hpp>

namespace winnow {

namespace {

void append_in_parts(Spool& spool, const std::string& content, test::Random& random,
                     std::size_t most) {
  std::size_t at = 0;
  for (const std::size_t part : random.parts(content.size(), most)) {
    spool.append(test::bytes_of(content).subspan(at, part));
    at += part;
    if (random.chance(0.1)) spool.append({});
  }
}

void check_content(const Spool& spool, const std::string& content, test::Random& random) {
  REQUIRE(spool.size() == content.size());
  for (int i = 0; i < (test::sanitized ? 20 : 200); ++i) {
    const std::size_t from = random.below(content.size() + 1);
    std::string part(random.below(content.size() - from + 1), '?');
    spool.read(from, std::as_writable_bytes(std::span(part)));
    REQUIRE(part == content.substr(from, part.size()));
  }
  for (const std::size_t unit :
       {std::size_t{1}, std::size_t{12}, std::size_t{48}, std::size_t{100'003}}) {
    std::string all;
    spool.for_each_part(unit, [&](std::span<const std::byte> part) {
      all += test::text_of(part);
      if (all.size() < content.size()) REQUIRE(part.size() % unit == 0);
    });
    REQUIRE(all == content);
  }
}

}  // namespace

TEST_CASE("a spool gives back what was appended, in memory and from scratch") {
  test::Random random(70);
  for (const std::size_t size :
       {std::size_t{1}, std::size_t{1000}, std::size_t{3} << 20, (std::size_t{5} << 20) + 7}) {
    const std::string content = random.bytes(size);
    for (const std::uint64_t limit : {std::uint64_t{0}, mebibyte, 2 * mebibyte, 100 * mebibyte}) {
      for (const std::size_t most : {std::size_t{5000}, std::size_t{700'000}}) {
        test::TestJob test;
        Spool spool(test.job, limit);
        append_in_parts(spool, content, random, most);
        spool.finish();
        CAPTURE(size, limit, most);
        REQUIRE(spool.in_memory() == (size <= limit));
        if (spool.in_memory()) {
          REQUIRE(test::text_of({spool.data(), content.size()}) == content);
          REQUIRE(test.job.scratch.written() == 0);
        } else {
          REQUIRE(test.job.budget.used() == 0);
          REQUIRE(spool.file().size() == content.size());
        }
        check_content(spool, content, random);
      }
    }
  }
}

TEST_CASE("a spool moves to scratch when the budget refuses, and gives its memory back") {
  test::Random random(71);
  const std::string content = random.bytes(6 * mebibyte);
  test::TestJob test({.memory = 10 * mebibyte});
  Reservation other = test.job.budget.reserve(6 * mebibyte, "the rest");
  Spool spool(test.job, 100 * mebibyte);
  std::uint64_t most = 0;
  std::size_t at = 0;
  for (const std::size_t part : random.parts(content.size(), 100'000)) {
    spool.append(test::bytes_of(content).subspan(at, part));
    at += part;
    most = std::max(most, test.job.budget.used());
  }
  spool.finish();
  CHECK(most > 9 * mebibyte);
  CHECK_FALSE(spool.in_memory());
  CHECK(test.job.budget.used() == 6 * mebibyte);
  check_content(spool, content, random);
}

TEST_CASE("a spool uses no more of the budget than its limit") {
  for (const std::uint64_t limit :
       {std::uint64_t{1}, mebibyte / 2, mebibyte, mebibyte + mebibyte / 2, 3 * mebibyte - 1}) {
    test::TestJob test;
    Spool spool(test.job, limit);
    const std::vector<std::byte> part(4096);
    std::uint64_t most = 0;
    for (std::uint64_t at = 0; at < 4 * mebibyte; at += part.size()) {
      spool.append(part);
      most = std::max(most, test.job.budget.used());
    }
    CAPTURE(limit);
    CHECK(most <= limit);
  }
}

TEST_CASE("an empty spool is empty") {
  for (const std::uint64_t limit : {std::uint64_t{0}, mebibyte}) {
    test::TestJob test;
    Spool spool(test.job, limit);
    spool.finish();
    CHECK(spool.size() == 0);
    int parts = 0;
    spool.for_each_part(12, [&](std::span<const std::byte>) { ++parts; });
    CHECK(parts == 0);
  }
}

}  // namespace winnow
