// Numbers in text are such as programs read.
#include "write/append_text.hpp"

#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include <catch2/catch.hpp>

namespace winnow {

TEST_CASE("a real number in text has a point or an exponent, and is finite") {
  const auto text_of = [](double value) {
    std::vector<std::byte> out;
    append_real(out, value);
    std::string text;
    for (const std::byte b : out) text += static_cast<char>(b);
    return text;
  };
  CHECK(text_of(1) == "1.0");
  CHECK(text_of(0.5) == "0.5");
  CHECK(text_of(-3) == "-3.0");
  for (const double huge : {1e100, -1e100, std::numeric_limits<double>::max()}) {
    CHECK(std::abs(std::stof(text_of(huge))) == std::numeric_limits<float>::max());
  }
}

}  // namespace winnow
