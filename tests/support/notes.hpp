// What a run notes.
#pragma once

#include <algorithm>
#include <string>
#include <vector>

namespace winnow::test {

// Whether one of them says this somewhere.
inline bool has_note(const std::vector<std::string>& notes, const std::string& part) {
  return std::any_of(notes.begin(), notes.end(),
                     [&](const std::string& note) { return note.find(part) != std::string::npos; });
}

}  // namespace winnow::test
