#include "read/text/tokens.hpp"

#include <winnow/error.hpp>

#include "base/text.hpp"

#include <algorithm>
#include <charconv>
#include <limits>

namespace winnow {

namespace {

constexpr std::size_t usual_block = std::size_t{1} << 16;
// A longer word is no number in any mesh file; without a limit a file of zeros would be read into
// memory.
constexpr std::size_t longest_word = std::size_t{1} << 16;

constexpr std::string_view byte_order_mark = "\xef\xbb\xbf";

constexpr std::size_t longest_number = 40;  // in messages

constexpr double infinity = std::numeric_limits<double>::infinity();

constexpr bool is_blank(char c) {
  return c == ' ' || (c >= '\t' && c <= '\r');
}

constexpr bool ends_line(char c) {
  return c == '\n' || c == '\r';
}

}  // namespace

bool TextTokens::refill() {
  if (ended_) return false;
  const std::size_t rest = text_.size() - at_;
  source_.give_back(rest);
  block_ = source_.take(rest + usual_block);
  ended_ = block_.bytes.size() < rest + usual_block;
  text_ = {reinterpret_cast<const char*>(block_.bytes.data()), block_.bytes.size()};
  at_ = 0;
  block_.check_intact(source_.name());
  return text_.size() > rest;
}

std::string_view TextTokens::next() {
  for (;;) {
    while (at_ < text_.size() && is_blank(text_[at_])) {
      line_ += text_[at_] == '\n' ? 1 : 0;
      ++at_;
    }
    if (at_ < text_.size()) break;
    if (!refill()) return {};
  }
  return take_word();
}

std::string_view TextTokens::next_in_line() {
  for (;;) {
    while (at_ < text_.size() && is_blank(text_[at_]) && !ends_line(text_[at_])) ++at_;
    if (at_ < text_.size()) break;
    if (!refill()) return {};
  }
  return ends_line(text_[at_]) ? std::string_view() : take_word();
}

std::string_view TextTokens::take_word() {
  std::size_t end = at_;
  for (;;) {
    while (end < text_.size() && !is_blank(text_[end])) ++end;
    if (end < text_.size()) break;
    const std::size_t length = end - at_;
    if (length > longest_word) {
      throw Error(ErrorKind::bad_input, "'" + source_.name() + "', line " + grouped(line_) +
                                            ", has a word of more than " +
                                            human_bytes(longest_word) +
                                            ": this is not a text file");
    }
    if (!refill()) break;
    end = length;
  }
  const std::string_view word = text_.substr(at_, end - at_);
  at_ = end;
  return word;
}

void TextTokens::skip_line() {
  for (;;) {
    while (at_ < text_.size()) {
      if (ends_line(text_[at_])) return;
      ++at_;
    }
    if (!refill()) return;
  }
}

void TextTokens::sync() {
  source_.give_back(text_.size() - at_);
  text_ = {};
  at_ = 0;
  ended_ = false;
}

std::string_view without_byte_order_mark(std::string_view text) {
  if (text.starts_with(byte_order_mark)) text.remove_prefix(byte_order_mark.size());
  return text;
}

void skip_byte_order_mark(ByteSource& source) {
  const Block block = source.peek(byte_order_mark.size());
  const std::string_view text(reinterpret_cast<const char*>(block.bytes.data()),
                              block.bytes.size());
  if (text == byte_order_mark) source.take(text.size());
}

bool is_text(std::string_view bytes) {
  // Names may hold codes for terminals, and files of DOS end in ^Z.
  constexpr std::string_view codes = "\a\b\x1a\x1b";
  return std::none_of(bytes.begin(), bytes.end(), [&](char c) {
    const auto byte = static_cast<unsigned char>(c);
    return byte < 0x20 && !is_blank(c) && codes.find(c) == std::string_view::npos;
  });
}

bool has_decimal_comma(std::string_view word) {
  std::string other(word.substr(0, longest_number));
  const std::size_t comma = other.find(',');
  if (comma == std::string::npos) return false;
  other[comma] = '.';
  return parse_real(other).has_value();
}

std::string not_a_number(std::string_view word) {
  return "'" + std::string(word.substr(0, longest_number)) + "' is not a number" +
         (has_decimal_comma(word) ? ": the decimal sign must be a point, not a comma" : "");
}

std::optional<double> parse_real(std::string_view word) {
  if (!word.empty() && word.front() == '+') word.remove_prefix(1);
  double value = 0;
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
  if (error == std::errc::result_out_of_range)
    return word.find('-', 1) != std::string_view::npos ? 0.0 : infinity;
  if (error != std::errc{}) return {};
  // Other programs write "nan(ind)", "1.#QNAN" and the like: a number that is not finite all the
  // same.
  if (end != word.data() + word.size() && *end != '(' && *end != '#') return {};
  return end != word.data() + word.size() && *end == '#' ? infinity : value;
}

std::optional<std::int64_t> parse_integer(std::string_view word) {
  if (!word.empty() && word.front() == '+') word.remove_prefix(1);
  std::int64_t value = 0;
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
  if (error == std::errc::result_out_of_range) return -1;
  if (error != std::errc{}) return {};
  if (end == word.data() + word.size()) return value;
  const std::optional<double> real = parse_real(word);
  if (!real || !(*real > -9.0e15 && *real < 9.0e15)) return {};
  return static_cast<std::int64_t>(*real);
}

}  // namespace winnow
