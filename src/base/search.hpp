// Searching what is in order and known by numbers alone, as records in scratch are.
#pragma once

#include <algorithm>
#include <cstdint>
#include <ranges>

namespace winnow {

// The first number from `low` on for which before(number) is false, or `high`; it must be true
// below some number and false from there on.
template <typename Before>
std::uint64_t first_not_before(std::uint64_t low, std::uint64_t high, const Before& before) {
  return *std::ranges::partition_point(std::views::iota(low, high), before);
}

}  // namespace winnow
