// Numbers in messages.
#include "base/text.hpp"

#include "support/random.hpp"

#include <bit>
#include <cmath>
#include <cstdlib>

#include <catch2/catch.hpp>

namespace winnow {

namespace {

// What human_bytes() says, read back.
double bytes_said(const std::string& text) {
  const std::size_t blank = text.find(' ');
  const std::string unit = text.substr(blank + 1);
  double scale = 1;
  for (const char* name : {"KiB", "MiB", "GiB", "TiB", "PiB", "EiB"}) {
    scale *= 1024;
    if (unit == name) return std::stod(text) * scale;
  }
  REQUIRE((unit == "bytes" || unit == "byte"));
  return std::stod(text);
}

}  // namespace

TEST_CASE("bytes are told to three digits") {
  CHECK(human_bytes(0) == "0 bytes");
  CHECK(human_bytes(1) == "1 byte");
  CHECK(human_bytes(84) == "84 bytes");
  CHECK(human_bytes(1023) == "1023 bytes");
  CHECK(human_bytes(1024) == "1 KiB");
  CHECK(human_bytes(1536) == "1.5 KiB");
  CHECK(human_bytes(std::uint64_t{512} << 20) == "512 MiB");
  CHECK(human_bytes((std::uint64_t{1} << 30) + (std::uint64_t{1} << 29)) == "1.5 GiB");
  CHECK(human_bytes(UINT64_MAX) == "16 EiB");
  test::Random random(6);
  for (int i = 0; i < 5000; ++i) {
    const std::uint64_t bytes = random.bits() >> random.below(64);
    CAPTURE(bytes, human_bytes(bytes));
    REQUIRE(std::abs(bytes_said(human_bytes(bytes)) - static_cast<double>(bytes)) <=
            0.055 * static_cast<double>(bytes));
    REQUIRE(human_bytes(bytes).size() <= 10);
  }
}

TEST_CASE("a size for --memory is never below the bytes it stands for") {
  CHECK(size_option(0) == "0M");
  CHECK(size_option(1) == "1M");
  CHECK(size_option(std::uint64_t{34} << 20) == "34M");
  CHECK(size_option((std::uint64_t{34} << 20) + 1) == "35M");
  test::Random random(7);
  for (int i = 0; i < 5000; ++i) {
    const std::uint64_t bytes = random.bits() >> random.between(0, 63);
    const std::string text = size_option(bytes);
    CAPTURE(bytes, text);
    REQUIRE(text.back() == 'M');
    const std::uint64_t said = std::stoull(text);
    REQUIRE(said >= bytes >> 20);
    REQUIRE((said - (bytes >> 20) == 1) == (bytes % (1 << 20) != 0));
  }
}

TEST_CASE("counts are grouped by threes") {
  CHECK(grouped(0) == "0");
  CHECK(grouped(999) == "999");
  CHECK(grouped(1000) == "1,000");
  CHECK(grouped(1'234'567) == "1,234,567");
  CHECK(grouped(UINT64_MAX) == "18,446,744,073,709,551,615");
  test::Random random(8);
  for (int i = 0; i < 2000; ++i) {
    const std::uint64_t count = random.bits() >> random.below(64);
    const std::string text = grouped(count);
    std::string digits;
    for (std::size_t at = 0; at < text.size(); ++at) {
      const bool comma = (text.size() - at) % 4 == 0;
      CAPTURE(text, at);
      REQUIRE((text[at] == ',') == comma);
      if (!comma) digits += text[at];
    }
    REQUIRE(digits == std::to_string(count));
  }
}

TEST_CASE("a length is told so that it reads back the same") {
  CHECK(shortest(0.1) == "0.1");
  CHECK(shortest(2.5) == "2.5");
  CHECK(shortest(5e6) == "5e+06");
  test::Random random(9);
  for (int i = 0; i < 5000; ++i) {
    const auto value = std::bit_cast<double>(random.bits());
    if (!std::isfinite(value)) continue;
    const std::string text = shortest(value);
    CAPTURE(text);
    REQUIRE(std::bit_cast<std::uint64_t>(std::strtod(text.c_str(), nullptr)) ==
            std::bit_cast<std::uint64_t>(value));
  }
}

}  // namespace winnow
