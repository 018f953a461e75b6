#include "read/text/lines.hpp"

#include <winnow/error.hpp>

#include "base/text.hpp"
#include "read/text/tokens.hpp"

#include <algorithm>

namespace winnow {

namespace {

constexpr std::size_t longest_planned = std::size_t{1} << 20;
constexpr std::size_t longest_line = std::size_t{1} << 30;
// The bytes twice while they are read on; a corner of two characters is 8 bytes, and 4 more when
// handed over.
constexpr std::uint64_t memory_a_byte = 2 + (8 + 4) / 2;

constexpr std::string_view line_blanks = " \t\v\f";

constexpr bool parts_words(char c) {
  return c == ' ' || (c >= '\t' && c <= '\r') || c == '\\';
}

// Of either kind, whichever the text uses.
std::uint64_t line_ends(std::string_view text) {
  const auto feeds = std::count(text.begin(), text.end(), '\n');
  return static_cast<std::uint64_t>(feeds != 0 ? feeds
                                               : std::count(text.begin(), text.end(), '\r'));
}

// By its first characters, whether a backslash at the end of a line joins the next to it.
bool may_be_continued(std::string_view text) {
  const std::size_t first = text.find_first_not_of(line_blanks);
  if (first == std::string_view::npos || first + 1 == text.size()) return false;
  return (text[first] == 'v' || text[first] == 'f') && parts_words(text[first + 1]);
}

// Blanks may follow. A backslash in a comment is none.
bool ends_in_backslash(std::string_view line) {
  const std::size_t last = line.find_last_not_of(line_blanks);
  return last != std::string_view::npos && line[last] == '\\' &&
         line.find('#') == std::string_view::npos;
}

// Just behind the last end of a line that has no backslash before it; 0 where there is none.
std::size_t last_plain_cut(std::string_view text) {
  const auto joined = [&](std::size_t at) {
    if (text[at] == '\n' && text[at - 1] == '\r') --at;
    while (at > 0 && line_blanks.find(text[at - 1]) != std::string_view::npos) --at;
    return at > 0 && text[at - 1] == '\\';
  };
  for (std::size_t at = text.rfind('\n'); at != std::string_view::npos && at > 0;
       at = text.rfind('\n', at - 1)) {
    if (!joined(at)) return at + 1;
  }
  // Lines that end with "\r" alone. Of the last character it is not known whether a "\n" follows.
  if (text.size() < 2 || text.find('\n') != std::string_view::npos) return 0;
  for (std::size_t at = text.rfind('\r', text.size() - 2); at != std::string_view::npos && at > 0;
       at = text.rfind('\r', at - 1)) {
    if (!joined(at)) return at + 1;
  }
  return 0;
}

// Just behind the last end of a line that is not joined to the next; 0 where there is none.
std::size_t last_cut(std::string_view text) {
  const std::size_t plain = last_plain_cut(text);
  if (plain > 0) return plain;
  TextLines each(text);
  std::size_t cut = 0;
  for (std::string_view line; each.next(line);) {
    // A "\n" may follow the last "\r".
    const auto end = static_cast<std::size_t>(line.data() - text.data()) + line.size();
    if (end + 1 < text.size() || (end + 1 == text.size() && text[end] == '\n')) cut = end + 1;
  }
  return cut;
}

}  // namespace

std::uint64_t TextBlock::line_of(std::string_view place) const {
  return first_line +
         line_ends(text().substr(0, static_cast<std::size_t>(place.data() - text().data())));
}

bool TextLines::next(std::string_view& line) {
  if (rest_.empty()) return false;
  const bool continued = may_be_continued(rest_);
  std::size_t end = 0;
  for (std::size_t begin = 0;; begin = end + 1) {
    end = std::min(rest_.find_first_of("\r\n", begin), rest_.size());
    if (end == rest_.size() || !continued || !ends_in_backslash(rest_.substr(begin, end - begin)))
      break;
    if (rest_[end] == '\r' && end + 1 < rest_.size() && rest_[end + 1] == '\n') ++end;
  }
  line = rest_.substr(0, end);
  rest_.remove_prefix(std::min(end + 1, rest_.size()));
  return true;
}

std::string_view LineWords::next() {
  std::size_t begin = 0;
  while (begin < rest_.size() && parts_words(rest_[begin])) ++begin;
  std::size_t end = begin;
  while (end < rest_.size() && !parts_words(rest_[end]) && rest_[end] != '#') ++end;
  const std::string_view word = rest_.substr(begin, end - begin);
  rest_.remove_prefix(end);
  if (word.empty()) rest_ = rest_.substr(rest_.size());
  return word;
}

TextBlocks::TextBlocks(Job& job, ByteSource& source, std::size_t bytes)
    : job_(job), source_(source), bytes_(bytes) {
  skip_byte_order_mark(source_);
}

bool TextBlocks::next(TextBlock& block) {
  block.long_line = false;
  for (std::size_t wanted = bytes_;; wanted *= 2) {
    block.block = source_.take(wanted);
    block.block.check_intact(source_.name());
    block.first_line = next_line_;
    if (block.block.bytes.size() < wanted) break;
    const std::size_t cut = last_cut(block.text());
    if (cut > 0) {
      source_.give_back(block.block.bytes.size() - cut);
      block.block.bytes = block.block.bytes.first(cut);
      break;
    }
    source_.give_back(block.block.bytes.size());
    job_.progress.check_cancelled();
    if (2 * wanted <= longest_planned) continue;
    reserve_for_line(2 * wanted);
    block.long_line = true;
  }
  next_line_ += line_ends(block.text());
  return !block.block.bytes.empty();
}

// What was reserved for an earlier line is kept: its bytes may be before those of the next block.
void TextBlocks::reserve_for_line(std::size_t bytes) {
  if (bytes <= longest_line) {
    if (long_line_.bytes() >= memory_a_byte * bytes) return;
    long_line_.release();
    long_line_ = job_.budget.try_reserve(memory_a_byte * bytes);
    if (long_line_) return;
  }
  // How long is it? Where a backslash joins lines that is not exact.
  std::size_t length = 0;
  for (bool ended = false; !ended && length <= longest_line; job_.progress.check_cancelled()) {
    const Block block = source_.take(std::size_t{1} << 16);
    const std::string_view text(reinterpret_cast<const char*>(block.bytes.data()),
                                block.bytes.size());
    std::size_t end = 0;
    do {
      end = std::min(text.find_first_of("\r\n", end), text.size());
    } while (end++ < text.size() && end > 1 && text[end - 2] == '\\');
    ended = text.empty() || end <= text.size();
    length += std::min(end, text.size());
    block.check_intact(source_.name());
  }
  if (length > longest_line) {
    throw Error(ErrorKind::bad_input, "'" + source_.name() + "', line " + grouped(next_line_) +
                                          ", is longer than " + human_bytes(longest_line) +
                                          ": this is no mesh as text");
  }
  while (bytes < length) bytes *= 2;
  const std::string what = "line " + grouped(next_line_) + " of '" + source_.name() + "', of " +
                           human_bytes(length) + ",";
  long_line_ = job_.budget.reserve(memory_a_byte * bytes, what.c_str());
}

void TextBlocks::give_back(TextBlock& block, std::string_view place) {
  const auto kept = static_cast<std::size_t>(place.data() - block.text().data());
  next_line_ -= line_ends(place);
  source_.give_back(block.block.bytes.size() - kept);
  block.block.bytes = block.block.bytes.first(kept);
}

}  // namespace winnow
