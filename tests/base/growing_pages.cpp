// Memory that grows inside the budget without moving.
#include "base/growing_pages.hpp"

#include "support/random.hpp"

#include <algorithm>

#include <catch2/catch.hpp>

namespace winnow {

namespace {

void fill(const GrowingPages& pages, std::size_t from, std::size_t to) {
  for (std::size_t i = from; i < to; ++i)
    pages.data()[i] = static_cast<std::byte>(i * 2654435761U >> 13);
}

bool holds(const GrowingPages& pages, std::size_t to) {
  for (std::size_t i = 0; i < to; ++i) {
    if (pages.data()[i] != static_cast<std::byte>(i * 2654435761U >> 13)) return false;
  }
  return true;
}
}  // namespace

TEST_CASE("what grows stays where it is and keeps its content") {
  Budget budget(64 * mebibyte);
  GrowingPages pages(budget, 20 * mebibyte);
  CHECK(pages.limit() == 20 * mebibyte);
  CHECK(pages.usable() == 0);
  CHECK(budget.used() == 0);
  const std::byte* const place = pages.data();
  test::Random random(3);
  std::size_t size = 0;
  while (size < 20 * mebibyte) {
    const std::size_t next =
        std::min<std::size_t>(20 * mebibyte, size + random.between(1, 2 * mebibyte));
    REQUIRE(pages.grow_to(next));
    REQUIRE(pages.usable() >= next);
    REQUIRE(pages.usable() <= pages.limit());
    REQUIRE(budget.used() == pages.usable());
    fill(pages, size, next);
    size = next;
  }
  CHECK(pages.data() == place);
  CHECK(holds(pages, size));
  CHECK(pages.grow_to(5));  // smaller than it is: nothing to do
  CHECK_FALSE(pages.grow_to(20 * mebibyte + 1));
  CHECK(budget.used() == 20 * mebibyte);
}

TEST_CASE("the budget stops the growing, down to the last step that fits") {
  Budget budget(43 * mebibyte);
  const Reservation other = budget.try_reserve(mebibyte);
  GrowingPages pages(budget, 100 * mebibyte);
  REQUIRE(pages.grow_to(40 * mebibyte));
  // An eighth more would not fit, what was asked does.
  REQUIRE(pages.grow_to(42 * mebibyte));
  fill(pages, 0, 42 * mebibyte);
  CHECK_FALSE(pages.grow_to(42 * mebibyte + 1));
  CHECK_FALSE(pages.grow_to(44 * mebibyte));
  CHECK(pages.usable() == 42 * mebibyte);
  CHECK(holds(pages, 42 * mebibyte));
  CHECK(budget.used() == 43 * mebibyte);
}

TEST_CASE("memory that was given back is zero when it comes again") {
  Budget budget(8 * mebibyte);
  GrowingPages pages(budget, 4 * mebibyte);
  pages.give_back();
  REQUIRE(pages.grow_to(3 * mebibyte));
  fill(pages, 0, 3 * mebibyte);
  pages.give_back();
  CHECK(pages.usable() == 0);
  CHECK(budget.used() == 0);
  REQUIRE(pages.grow_to(4 * mebibyte));
  CHECK(std::all_of(pages.data(), pages.data() + 4 * mebibyte,
                    [](std::byte b) { return b == std::byte{0}; }));
}

TEST_CASE("growing pages give everything back when they go, also after moving") {
  Budget budget(8 * mebibyte);
  {
    GrowingPages first(budget, 4 * mebibyte);
    REQUIRE(first.grow_to(2 * mebibyte));
    fill(first, 0, 2 * mebibyte);
    GrowingPages second = std::move(first);
    CHECK(holds(second, 2 * mebibyte));
    CHECK(first.usable() == 0);
    GrowingPages third(budget, 2 * mebibyte);
    REQUIRE(third.grow_to(1));
    third = std::move(second);
    CHECK(holds(third, 2 * mebibyte));
    CHECK(third.grow_to(4 * mebibyte));
  }
  CHECK(budget.used() == 0);
}

TEST_CASE("a limit of nothing holds nothing") {
  Budget budget(8 * mebibyte);
  GrowingPages pages(budget, 0);
  CHECK(pages.grow_to(0));
  CHECK_FALSE(pages.grow_to(1));
  GrowingPages none;
  CHECK_FALSE(none.grow_to(1));
}

}  // namespace winnow
