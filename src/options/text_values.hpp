// Values of options as text, and back to exactly the same value.
#pragma once

#include <winnow/distance.hpp>

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <string>
#include <vector>

namespace winnow {

// What a number may be, and how a message says so.
struct NumberRange {
  double low = -std::numeric_limits<double>::infinity();
  double high = std::numeric_limits<double>::infinity();
  bool low_open = false, high_open = false;  // the end itself is not one
  const char* words = "";                    // "an angle above 0 and at most 90 degrees"
};

// "`option` takes WHAT, not 'TEXT'" as Error(usage).
[[noreturn]] void refuse_value(const std::string& option, const std::string& what,
                               const std::string& text);

// All of these throw Error(usage) that names `option`. `examples`: what it takes, in words.
double number_in(const std::string& text, const std::string& option, const char* examples,
                 const NumberRange& range);
// 0.01 or 1%
double ratio_in(const std::string& text, const std::string& option, const NumberRange& range);
// 0.5, in model units, or 0.1%, a part of the diagonal.
Distance distance_in(const std::string& text, const std::string& option, const NumberRange& length,
                     const NumberRange& part);
// 250000, 500k, 1.5M, 2G: thousands
std::uint64_t count_in(const std::string& text, const std::string& option, std::uint64_t least,
                       std::uint64_t most, const char* words);
// 64M, 1.5G, 1GB, 1GiB
std::uint64_t size_in(const std::string& text, const std::string& option);
// 1,-2,0.5
void numbers_in(const std::string& text, const std::string& option, const char* examples,
                std::span<double> numbers);
// normals,colors,quality; a backslash takes the meaning from the comma or backslash behind it.
std::vector<std::string> names_in(const std::string& text, const std::string& option);

std::string text_of(const Distance& distance);
std::string text_of(std::span<const double> numbers);
std::string text_of(const std::vector<std::string>& names);

}  // namespace winnow
