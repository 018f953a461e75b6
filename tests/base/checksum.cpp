// A checksum is of the content alone, however it came.
#include "base/checksum.hpp"

#include "support/random.hpp"
#include "support/sources.hpp"

#include <catch2/catch.hpp>

namespace winnow {

TEST_CASE("a checksum does not depend on the parts that the content came in") {
  test::Random random(5);
  for (const std::size_t size : {0, 1, 31, 32, 33, 64, 1000, 4096}) {
    const std::string content = random.bytes(size);
    const std::uint64_t whole = Checksum::of(test::bytes_of(content));
    for (const std::size_t most : {1, 7, 32, 40, 1000}) {
      Checksum sum;
      std::size_t at = 0;
      for (const std::size_t part : random.parts(size, most)) {
        sum.add(test::bytes_of(content).subspan(at, part));
        (void)sum.value();  // asking changes nothing
        at += part;
      }
      CAPTURE(size, most);
      REQUIRE(sum.value() == whole);
    }
  }
}

TEST_CASE("any changed bit, and any zero more or less, changes the checksum") {
  std::string content(100, '\0');
  const std::uint64_t sum = Checksum::of(test::bytes_of(content));
  for (std::size_t size = 0; size < 100; ++size)
    REQUIRE(Checksum::of(test::bytes_of(content).first(size)) != sum);
  for (std::size_t bit = 0; bit < 800; ++bit) {
    content[bit / 8] = static_cast<char>(1U << bit % 8);
    REQUIRE(Checksum::of(test::bytes_of(content)) != sum);
    REQUIRE(static_cast<std::uint32_t>(Checksum::of(test::bytes_of(content))) !=
            static_cast<std::uint32_t>(sum));
    content[bit / 8] = 0;
  }
}

}  // namespace winnow
