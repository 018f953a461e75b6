// Meshes as text with a record a line, parsed by all threads.
#pragma once

#include "read/buffered_reader.hpp"
#include "read/text/lines.hpp"

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace winnow {

// What one block of lines holds.
class ParsedLines {
 public:
  ParsedLines(const TextBlock& block, const BufferedMesh& mesh);

  // Three coordinates, the next words of a line.
  void add_position(LineWords& words);

  // Of the last position's vertex the next words of its line, as many as attributes are offered.
  // Where words are missing, no vertex carries anything, or, if they are `required`, it is an
  // error.
  void add_attributes(LineWords& words, bool required);

  // What the next position's vertex is called; for all vertices or for none. Corners then name
  // vertices so.
  void add_number(std::uint32_t number) { numbers_.push_back(number); }

  // A corner counts vertices from 0, over the whole file or, relative, from the block's first on
  // (negative: before it).
  void add_corner(std::int64_t vertex, bool relative);
  void end_face();

  // As BufferedMesh has it; `what` is a constant.
  void pass_over(const char* what);

  [[nodiscard]] std::int64_t vertices() const { return static_cast<std::int64_t>(xyz_.size() / 3); }

  // Throws Error(bad_input) naming the line that `place` stands in.
  [[noreturn]] void fail(std::string_view place, const std::string& what) const;
  // The same for a word that should be a number.
  [[noreturn]] void fail_number(std::string_view word, std::string_view place) const;

  void hand_over(BufferedMesh& mesh) const;

 private:
  const TextBlock& block_;
  const BufferedMesh& mesh_;
  std::vector<double> xyz_;
  std::vector<double> attributes_;
  bool some_lack_attributes_ = false;
  std::vector<std::uint32_t> numbers_;
  bool single_ = true;
  std::vector<std::int64_t> corners_;  // twice the number, plus one where it is relative
  std::vector<std::uint32_t> sizes_;   // corners of each face
  std::uint32_t open_ = 0;             // of the face at work
  std::vector<const char*> passed_over_;
};

// Cuts blocks off, parses them in parallel, a long line alone, and hands them over in their order.
// `parse` takes a block apart.
struct TextParser {
  std::function<bool(TextBlock&)> next;
  std::function<void(const TextBlock&, ParsedLines&)> parse;
};
void parse_text(const TextParser& parser, BufferedMesh& mesh);

// The lines that stand whole in the first bytes.
std::string first_lines(ByteSource& source);

// What vertices carry by the first lines.
template <AvailableAttributes (*offer)(std::string_view head)>
void probe_by_lines(Job& /*job*/, ByteSource& source, bool /*asked*/, InputProbe& probe) {
  probe.facts.offer = offer(first_lines(source));
}

// Bytes of text at once, so that a block and what it holds take no more than a batch of faces.
constexpr std::size_t text_block_bytes(std::size_t batch_faces) {
  return 8 * batch_faces;
}

}  // namespace winnow
