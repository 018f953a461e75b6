// What the first bytes of an STL say.
#pragma once

#include "read/formats.hpp"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace winnow {

inline constexpr std::size_t stl_header_bytes = 84;
inline constexpr std::size_t stl_face_bytes = 50;

struct StlHead {
  bool ascii = false;
  bool exact = false;                   // binary: the count must be right
  std::uint32_t declared = 0;           // binary only
  std::optional<std::uint64_t> stored;  // whole faces by the file's size, where that is known
};

// What there is to decide by: whether the count fits the size, whether it reads like text. Throws
// Error(bad_input) where it is no STL, or, if it is not `asked` for, a binary one whose count is
// wrong.
StlHead look_at_stl(ByteSource& source, bool asked);
InputFacts facts_of(const StlHead& head);

// How surely a text is one.
TextMatch match_stl(std::string_view head);
// Whether a word is `small`, which is in small letters.
bool is_stl_word(std::string_view word, std::string_view small);

// Whether a binary header may declare so many faces of a file that has so many.
bool is_stl_count(std::uint64_t declared, std::uint64_t faces);
[[noreturn]] void refuse_stl_count(const std::string& name, std::uint64_t declared,
                                   std::uint64_t stored);

}  // namespace winnow
