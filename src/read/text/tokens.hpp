// Words of a text, separated by blanks and line ends.
#pragma once

#include "io/byte_source.hpp"

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace winnow {

class TextTokens {
 public:
  explicit TextTokens(ByteSource& source) : source_(source) {}

  // The next word, valid until the next call; empty at the end of the content.
  std::string_view next();

  // The same, but empty at the end of the line, too.
  std::string_view next_in_line();

  void skip_line();  // the rest of the line the last word stood in
  void sync();       // gives back to the source what was not used

  [[nodiscard]] std::uint64_t line() const {
    return line_;
  }  // of the last word, from 1 where reading began
  void start_line(std::uint64_t line) { line_ = line; }

 private:
  std::string_view take_word();
  bool refill();  // keeps the bytes from at_ on; false at the end of the content

  ByteSource& source_;
  Block block_;
  std::string_view text_;
  std::size_t at_ = 0;
  std::uint64_t line_ = 1;
  bool ended_ = false;
};

// The text without the UTF-8 byte order mark that it may begin with.
std::string_view without_byte_order_mark(std::string_view text);

// Passes over the mark if the next bytes are one.
void skip_byte_order_mark(ByteSource& source);

// Whether bytes look like text, in whatever encoding has blanks and line ends as ASCII has.
bool is_text(std::string_view bytes);

// Whether a word is a number but for its decimal sign: "1,5".
bool has_decimal_comma(std::string_view word);

// Why a word is no number, for messages: "'x' is not a number".
std::string not_a_number(std::string_view word);

// The whole word as a number; "nan" and "inf" in any spelling are numbers.
std::optional<double> parse_real(std::string_view word);
std::optional<std::int64_t> parse_integer(std::string_view word);

}  // namespace winnow
