// Large memory is zeroed, counted, and gone when it goes.
#include "base/pages.hpp"

#include <winnow/error.hpp>

#include "support/job.hpp"

#include <algorithm>

#include <catch2/catch.hpp>

namespace winnow {

namespace {
bool all_zero(const Pages& pages) {
  const auto words = pages.as<std::uint64_t>();
  return std::all_of(words.begin(), words.end(), [](std::uint64_t word) { return word == 0; });
}
}  // namespace

TEST_CASE("pages are zero, also after they were written and cleared") {
  Budget budget(std::uint64_t{64} << 20);
  for (const std::size_t bytes :
       {std::size_t{8}, std::size_t{4096}, std::size_t{100'000}, std::size_t{9} << 20}) {
    CAPTURE(bytes);
    Pages pages = Pages::try_allocate(budget, bytes);
    REQUIRE(pages);
    CHECK(pages.size() == bytes);
    CHECK(pages.as<std::uint64_t>().size() == bytes / 8);
    CHECK(all_zero(pages));
    std::fill_n(pages.data(), bytes, std::byte{0xee});
    CHECK_FALSE(all_zero(pages));
    pages.clear();
    CHECK(all_zero(pages));
    std::fill_n(pages.data(), bytes, std::byte{0x11});
  }
}

TEST_CASE("pages take what they hold from the budget and give it back") {
  Budget budget(std::uint64_t{1} << 20);
  {
    Pages first = Pages::try_allocate(budget, 600'000);
    REQUIRE(first);
    CHECK(budget.used() == 600'000);
    CHECK_FALSE(Pages::try_allocate(budget, 600'000));
    CHECK(budget.used() == 600'000);

    std::byte* const place = first.data();
    Pages second = std::move(first);
    CHECK_FALSE(first);
    CHECK(second.data() == place);
    CHECK(budget.used() == 600'000);
    second = Pages::try_allocate(budget, 400'000);
    CHECK(budget.used() == 400'000);
    second = {};
    CHECK(budget.used() == 0);
  }
  CHECK(budget.used() == 0);
}

TEST_CASE("pages that have to be there say what they were for") {
  Budget budget(1000);
  const Error error = test::error_of([&] { (void)Pages::allocate(budget, 1001, "the cells"); });
  CHECK(error.kind() == ErrorKind::resources);
  CHECK(std::string(error.what()).find("the cells") != std::string::npos);
  CHECK(Pages::allocate(budget, 1000, "the cells"));
}

}  // namespace winnow
