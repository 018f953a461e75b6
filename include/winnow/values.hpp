// Enumerations whose values tell facts of themselves: facts_of(value). A switch without default
// gives them, so a value without facts does not compile; other numbers have no name.
#pragma once

#include <array>
#include <cstddef>

namespace winnow {

template <typename Enum>
constexpr std::size_t count_values() {
  std::size_t count = 0;
  while (facts_of(static_cast<Enum>(count)).name != nullptr) ++count;
  return count;
}

// Every value that facts_of() knows, in their order: all_values<Format>().
template <typename Enum>
constexpr std::array<Enum, count_values<Enum>()> all_values() {
  std::array<Enum, count_values<Enum>()> values{};
  for (std::size_t i = 0; i < values.size(); ++i) values[i] = static_cast<Enum>(i);
  return values;
}

}  // namespace winnow
