// Searching what is in order and known by numbers alone, as records in scratch are.
#pragma once

#include <cstdint>

namespace winnow {

// The first number from `low` on for which before(number) is false, or `high`; it must be true
// below some number and false from there on.
template <typename Before>
std::uint64_t first_not_before(std::uint64_t low, std::uint64_t high, const Before& before) {
  while (low < high) {
    const std::uint64_t middle = low + (high - low) / 2;
    if (before(middle)) {
      low = middle + 1;
    } else {
      high = middle;
    }
  }
  return low;
}

}  // namespace winnow
