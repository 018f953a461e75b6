// Numbers as options take them, besides those for people; letters.
#pragma once

#include <winnow/text.hpp>

#include <cstdint>
#include <string>

namespace winnow {

std::string size_option(std::uint64_t bytes);  // "34M": rounded up, as --memory takes it
std::string shortest(double value);  // the shortest text that reads back as the same double

// The small letter of a capital one of ASCII, and the other way round, whatever the locale.
constexpr char ascii_to_lower(char c) {
  return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
}

constexpr char ascii_to_upper(char c) {
  return c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c;
}

}  // namespace winnow
