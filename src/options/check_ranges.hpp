// Whether each option is in its range, by the table alone.
#pragma once

#include <winnow/options.hpp>

#include <span>
#include <string>

namespace winnow {

// Throws Error(usage) where a field holds what its option does not take.
template <typename Options>
void check_ranges(std::span<const Option<Options>> table, const Options& options) {
  for (const Option<Options>& option : table) {
    Options scratch;
    if (const std::string text = option.get(options); !text.empty()) option.set(scratch, text);
  }
}

}  // namespace winnow
