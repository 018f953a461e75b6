// Texts with a record a line, cut into blocks of whole lines that threads take apart.
#pragma once

#include "base/budget.hpp"
#include "io/byte_source.hpp"
#include "io/job.hpp"

#include <cstdint>
#include <string_view>

namespace winnow {

// What a format and its attributes are told by.
constexpr std::size_t text_head_bytes = std::size_t{1} << 16;

// A stretch of whole lines.
struct TextBlock {
  Block block;
  std::uint64_t first_line = 1;
  bool long_line = false;  // larger than planned, so only one at a time

  [[nodiscard]] std::string_view text() const {
    return {reinterpret_cast<const char*>(block.bytes.data()), block.bytes.size()};
  }
  // The number of the line that `place`, a part of text(), stands in.
  [[nodiscard]] std::uint64_t line_of(std::string_view place) const;
};

// The lines of a block one after the other. They end at "\n", "\r" or both. A backslash before that
// joins the next to it in statements "v" and "f" alone: what is passed over may end in a name, and
// a name in a backslash.
class TextLines {
 public:
  explicit TextLines(std::string_view text) : rest_(text) {}
  bool next(std::string_view& line);

 private:
  std::string_view rest_;
};

// The words of a line, up to a '#'.
class LineWords {
 public:
  explicit LineWords(std::string_view line) : rest_(line) {}
  std::string_view next();  // empty at the end

  // Where next() goes on: behind the last word.
  [[nodiscard]] std::string_view rest() const { return rest_; }

 private:
  std::string_view rest_;
};

// Cuts a source into blocks.
class TextBlocks {
 public:
  // Blocks have about `bytes`; a longer line makes a longer one.
  // Begins behind a byte order mark.
  TextBlocks(Job& job, ByteSource& source, std::size_t bytes);

  // False at the end. For a long line it reserves what reading and parsing it takes. Throws
  // Error(resources) where the budget does not hold that, naming one that does, and
  // Error(bad_input) where a line is longer than any mesh's.
  bool next(TextBlock& block);

  // Leaves the last block's text from `place` on for the next block.
  void give_back(TextBlock& block, std::string_view place);

 private:
  void reserve_for_line(std::size_t bytes);

  Job& job_;
  ByteSource& source_;
  std::size_t bytes_;
  Reservation long_line_;
  std::uint64_t next_line_ = 1;
};

}  // namespace winnow
