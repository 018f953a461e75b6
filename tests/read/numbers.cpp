// Words of text files as numbers.
#include "read/text/tokens.hpp"
#include "support/job.hpp"
#include "support/random.hpp"
#include "support/sources.hpp"

#include <bit>
#include <charconv>
#include <cmath>
#include <cstdio>
#include <limits>

#include <catch2/catch.hpp>

namespace winnow {

TEST_CASE("reals are read to the last bit, however they are written") {
  test::Random random(200);
  for (int i = 0; i < 20000; ++i) {
    const auto value = std::bit_cast<double>(random.bits());
    if (!std::isfinite(value)) continue;
    std::array<char, 64> text{};
    for (const char* form : {"%.17g", "%.17e", "%.17E", "%+.17g"}) {
      std::snprintf(text.data(), text.size(), form, value);
      const std::optional<double> read = parse_real(text.data());
      CAPTURE(text.data());
      // What is smaller than any normal number may come as nothing.
      REQUIRE(read);
      if (std::abs(value) >= std::numeric_limits<double>::min()) REQUIRE(*read == value);
    }
  }
  CHECK(parse_real("1") == 1.0);
  CHECK(parse_real("-0.5e1") == -5.0);
  CHECK(parse_real(".5") == 0.5);
  CHECK(parse_real("5.") == 5.0);
}

TEST_CASE("what is no finite number in any spelling is one that is not finite") {
  for (const char* word :
       {"nan", "NaN", "-nan", "nan(ind)", "-nan(ind)", "-nan(snan)", "inf", "-inf", "INF",
        "Infinity", "+inf", "1.#QNAN", "1.#INF", "-1.#IND", "1e999", "-1e999", "+1e400"}) {
    CAPTURE(word);
    const std::optional<double> value = parse_real(word);
    REQUIRE(value);
    CHECK_FALSE(std::isfinite(*value));
  }
  for (const char* word : {"1e-999", "-1e-999"}) CHECK(parse_real(word) == 0.0);
}

TEST_CASE("what is no number is none") {
  for (const char* word :
       {"", "x", "-", "+", ".", "e5", "1x", "1,5", "0x10", "1.5.2", "--1", "vertex", "1e"}) {
    CAPTURE(word);
    CHECK_FALSE(parse_real(word));
    CHECK_FALSE(parse_integer(word));
  }
}

TEST_CASE("integers are read, and reals in their place are cut") {
  CHECK(parse_integer("0") == 0);
  CHECK(parse_integer("-1") == -1);
  CHECK(parse_integer("+17") == 17);
  CHECK(parse_integer("4294967295") == 4294967295);
  CHECK(parse_integer("3.0") == 3);
  CHECK(parse_integer("3.9") == 3);
  CHECK(parse_integer("1e3") == 1000);
  // No vertex has any of these.
  for (const char* word : {"99999999999999999999", "-99999999999999999999"}) {
    CAPTURE(word);
    const std::optional<std::int64_t> value = parse_integer(word);
    REQUIRE(value);
    CHECK(*value < 0);
  }
  CHECK_FALSE(parse_integer("nan"));
}

TEST_CASE("words are found across blocks, with the lines they stand in") {
  test::Random random(201);
  // Blocks are 64 KiB: words fall onto their ends.
  std::string text;
  std::vector<std::pair<std::string, std::uint64_t>> words;
  std::uint64_t line = 1;
  while (text.size() < 400'000) {
    const std::string blanks =
        random.one_of<std::string>({" ", "\n", "\t", "  ", "\r\n", "\n\n", " \n\t", "\v", "\f"});
    for (const char c : blanks) line += c == '\n' ? 1 : 0;
    text += blanks;
    std::string word(random.between(1, random.chance(0.01) ? 3000 : 12), 'a');
    for (char& c : word) c = static_cast<char>('!' + random.below(90));
    text += word;
    words.emplace_back(word, line);
  }
  test::MemorySource source(text);
  TextTokens tokens(source);
  for (const auto& [word, at] : words) {
    REQUIRE(tokens.next() == word);
    REQUIRE(tokens.line() == at);
  }
  CHECK(tokens.next().empty());
  CHECK(tokens.next().empty());
}

TEST_CASE("the rest of a line can be skipped, and what was not used is given back") {
  test::MemorySource source("one two three\nfour five\n\nsix" + std::string(200'000, ' ') +
                            "seven\neight");
  TextTokens tokens(source);
  CHECK(tokens.next() == "one");
  tokens.skip_line();
  CHECK(tokens.next() == "four");
  CHECK(tokens.next() == "five");
  tokens.sync();
  CHECK(source.position() == std::string("one two three\nfour five").size());
  CHECK(tokens.next() == "six");
  tokens.skip_line();
  CHECK(tokens.next() == "eight");
  tokens.skip_line();
  CHECK(tokens.next().empty());
}

TEST_CASE("a word without an end is refused before it fills the memory") {
  test::MemorySource source(std::string(std::size_t{50} << 20, 'x'));
  TextTokens tokens(source);
  CHECK(test::error_of([&] { tokens.next(); }).kind() == ErrorKind::bad_input);
  CHECK(source.largest_take() < std::size_t{1} << 20);
}

}  // namespace winnow
