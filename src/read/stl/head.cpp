#include "read/stl/head.hpp"

#include <winnow/error.hpp>

#include "base/text.hpp"
#include "read/foreign_formats.hpp"
#include "read/text/lines.hpp"
#include "read/text/tokens.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>

namespace winnow {

namespace {

constexpr auto equals_small = [](char a, char b) { return ascii_to_lower(a) == b; };

// `word` in small letters.
bool contains_word(std::string_view text, std::string_view word) {
  return std::search(text.begin(), text.end(), word.begin(), word.end(), equals_small) !=
         text.end();
}

// Any binary file could be an STL. Whether half of the faces that are looked at are of numbers that
// a model may have.
bool looks_like_faces(std::string_view head) {
  std::size_t faces = 0, likely = 0;
  for (std::size_t at = stl_header_bytes; at + stl_face_bytes <= head.size();
       at += stl_face_bytes) {
    std::array<float, 12> numbers{};
    std::memcpy(numbers.data(), head.data() + at, sizeof numbers);
    ++faces;
    likely += std::all_of(numbers.begin(), numbers.end(), [](float x) {
      const float size = std::abs(x);
      return size == 0 || (size > 1e-30F && size < 1e30F);
    });
  }
  return 2 * likely >= faces;
}

}  // namespace

bool is_stl_word(std::string_view word, std::string_view small) {
  return std::equal(word.begin(), word.end(), small.begin(), small.end(), equals_small);
}

// The field has 32 bits.
bool is_stl_count(std::uint64_t declared, std::uint64_t faces) {
  return declared == faces || (declared == UINT32_MAX && faces > declared);
}

void refuse_stl_count(const std::string& name, std::uint64_t declared, std::uint64_t stored) {
  throw Error(ErrorKind::bad_input,
              "'" + name + "' is no mesh in a format that winnow reads, or a damaged " +
                  "STL: its header would say " + grouped(declared) +
                  " faces, and it has room for " + grouped(stored) +
                  "; `from` stl reads it all the same");
}

TextMatch match_stl(std::string_view head) {
  TextMatch match = TextMatch::first;
  TextLines each(head);
  for (std::string_view line; each.next(line);) {
    LineWords words(line);
    const std::string_view word = words.next();
    if (word.empty() || word.starts_with("//") || word.front() == ';') continue;
    if ((is_stl_word(word, "facet") && is_stl_word(words.next(), "normal")) ||
        (is_stl_word(word, "outer") && is_stl_word(words.next(), "loop"))) {
      return match;
    }
    // A long name can fill what was looked at.
    if (is_stl_word(word, "solid") &&
        (contains_word(head, "facet") || contains_word(head, "vertex") ||
         contains_word(head, "endsolid") || contains_word(head, "end solid") ||
         head.size() < stl_header_bytes || head.size() + 3 >= text_head_bytes)) {
      return match;
    }
    match = TextMatch::later;
  }
  return TextMatch::none;
}

// Many binary files begin with "solid" all the same.
StlHead look_at_stl(ByteSource& source, bool asked) {
  const Block block = source.peek(1024);
  const std::string_view head(reinterpret_cast<const char*>(block.bytes.data()),
                              block.bytes.size());
  if (head.empty()) throw Error(ErrorKind::bad_input, "'" + source.name() + "' is empty");
  StlHead found;
  if (head.size() >= stl_header_bytes)
    std::memcpy(&found.declared, head.data() + 80, sizeof found.declared);
  if (source.size() && *source.size() >= stl_header_bytes)
    found.stored = (*source.size() - stl_header_bytes) / stl_face_bytes;
  if (has_size_of_binary_stl(source)) return found;
  const std::string wrong = "'" + source.name() + "' is no mesh in a format that winnow reads: ";
  if (is_text(head)) {
    const Block more = source.peek(text_head_bytes);
    const std::string_view text = without_byte_order_mark(
        {reinterpret_cast<const char*>(more.bytes.data()), more.bytes.size()});
    found.ascii = match_stl(text) != TextMatch::none;
    if (found.ascii) return found;
    throw Error(ErrorKind::bad_input, wrong + kind_of_text(text));
  }
  if (head.size() < stl_header_bytes)
    throw Error(ErrorKind::bad_input,
                wrong + human_bytes(head.size()) + " are too short for an STL");
  // A random file would be read as a handful of wild faces. A damaged STL has a count that its size
  // nearly fits.
  if (found.stored && *found.stored == 0 && found.declared != 0) {
    throw Error(
        ErrorKind::bad_input,
        "'" + source.name() + "' ends inside its first face: it was cut short, or is no STL");
  }
  if (found.stored != found.declared && !looks_like_faces(head)) {
    throw Error(ErrorKind::bad_input, wrong +
                                          "as a binary STL it would have faces of wild numbers" +
                                          (found.stored ? ", and another size" : ""));
  }
  found.exact = !asked;
  if (found.exact && found.stored && !is_stl_count(found.declared, *found.stored))
    refuse_stl_count(source.name(), found.declared, *found.stored);
  return found;
}

InputFacts facts_of(const StlHead& head) {
  InputFacts facts;
  facts.format = head.ascii ? "STL ASCII" : "STL binary";
  if (!head.ascii) facts.faces = head.stored ? *head.stored : std::optional<std::uint64_t>{};
  return facts;
}

bool has_size_of_binary_stl(ByteSource& source) {
  if (!source.size() || *source.size() < stl_header_bytes) return false;
  const Block block = source.peek(stl_header_bytes);
  std::uint32_t declared = 0;
  std::memcpy(&declared, block.bytes.data() + 80, sizeof declared);
  return *source.size() == stl_header_bytes + stl_face_bytes * std::uint64_t{declared};
}

}  // namespace winnow
