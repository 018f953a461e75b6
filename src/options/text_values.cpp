#include "options/text_values.hpp"

#include <winnow/error.hpp>

#include "base/text.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdlib>
#include <string_view>

namespace winnow {

namespace {

constexpr std::string_view count_examples = "a count like 250000, 500k, 1.5M or 2G";
constexpr std::string_view size_examples = "a size like 512M or 2G";

// The number at the front; `rest` is what follows it.
bool read_front(std::string_view text, double& value, std::string_view& rest) {
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  rest = text.substr(static_cast<std::size_t>(end - text.data()));
  return error == std::errc{} && std::isfinite(value);
}

// A hundredth of the number that `text` is, rounded once: 0.1 is 0.1e-2.
double hundredth_of(std::string_view text) {
  const std::size_t exponent = text.find_first_of("eE");
  const std::string digits(text.substr(0, exponent));
  long power = 0;
  if (exponent != std::string_view::npos)
    power = std::strtol(std::string(text.substr(exponent + 1)).c_str(), nullptr, 10);
  const std::string shifted = digits + "e" + std::to_string(power - 2);
  double value = 0;
  std::from_chars(shifted.data(), shifted.data() + shifted.size(), value);
  return value;
}

// The shortest text of a hundred times `value`, of which hundredth_of() is `value`.
std::string hundredfold(double value) {
  if (!std::isfinite(value)) return shortest(value);
  std::array<char, 64> scientific{};
  const auto end = std::to_chars(scientific.data(), scientific.data() + scientific.size(), value,
                                 std::chars_format::scientific)
                       .ptr;
  const std::string text(scientific.data(), end);
  const std::size_t exponent = text.find('e');
  const long power = std::strtol(text.c_str() + exponent + 1, nullptr, 10) + 2;
  const std::string shifted = text.substr(0, exponent) + "e" + std::to_string(power);
  // As people write it, where that is the same number.
  const std::string plain = shortest(100 * value);
  return hundredth_of(plain) == value ? plain : shifted;
}

bool within(double value, const NumberRange& range) {
  const bool above = range.low_open ? value > range.low : value >= range.low;
  const bool below = range.high_open ? value < range.high : value <= range.high;
  return above && below;
}

void check(double value, const NumberRange& range, const std::string& option,
           const std::string& shown) {
  if (!within(value, range))
    throw Error(ErrorKind::usage, "`" + option + "` takes " + range.words + ", not " + shown);
}

std::uint64_t scaled_in(const std::string& text, const std::string& option,
                        std::string_view examples, double step) {
  const auto refuse = [&] { refuse_value(option, std::string(examples), text); };
  double value = 0;
  std::string_view rest;
  if (!read_front(text, value, rest)) refuse();
  constexpr std::string_view units = "kMGT";
  if (!rest.empty()) {
    std::size_t unit = units.find(rest.front());
    if (rest.front() == 'K') unit = 0;
    if (rest.front() == 'm') unit = 1;
    if (rest.front() == 'g') unit = 2;
    if (unit == std::string_view::npos) refuse();
    rest.remove_prefix(1);
    for (std::size_t i = 0; i <= unit; ++i) value *= step;
    if (step == 1024 && (rest == "iB" || rest == "ib" || rest == "B" || rest == "b")) rest = {};
    if (!rest.empty()) refuse();
  }
  if (!(value >= 0 && value < 0x1p63)) refuse();
  // 0.3G is a whole number that no double holds exactly on the way; 1.5 is none.
  if (std::abs(value - std::round(value)) > 1e-6 * value) refuse();
  return static_cast<std::uint64_t>(std::llround(value));
}

bool all_digits(std::string_view text) {
  return !text.empty() && text.find_first_not_of("0123456789") == std::string_view::npos;
}

// Digits alone are read as they are: a double does not hold all of them.
std::uint64_t whole_in(const std::string& text, const std::string& option,
                       std::string_view examples, double step) {
  std::uint64_t value = 0;
  if (!all_digits(text)) return scaled_in(text, option, examples, step);
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc{} || value >> 63 != 0) refuse_value(option, std::string(examples), text);
  return value;
}

}  // namespace

void refuse_value(const std::string& option, const std::string& what, const std::string& text) {
  throw Error(ErrorKind::usage, "`" + option + "` takes " + what + ", not '" + text + "'");
}

double number_in(const std::string& text, const std::string& option, const char* examples,
                 const NumberRange& range) {
  double value = 0;
  std::string_view rest;
  if (!read_front(text, value, rest) || !rest.empty()) refuse_value(option, examples, text);
  check(value, range, option, text);
  return value;
}

double ratio_in(const std::string& text, const std::string& option, const NumberRange& range) {
  double value = 0;
  std::string_view rest;
  if (!read_front(text, value, rest) || (!rest.empty() && rest != "%"))
    refuse_value(option, "a ratio like 0.01 or 1%", text);
  if (rest == "%") value = hundredth_of(std::string_view(text).substr(0, text.size() - 1));
  check(value, range, option, text);
  return value;
}

Distance distance_in(const std::string& text, const std::string& option, const NumberRange& length,
                     const NumberRange& part) {
  double value = 0;
  std::string_view rest;
  if (!read_front(text, value, rest) || (!rest.empty() && rest != "%"))
    refuse_value(option,
                 "a distance like 0.5, a bare number in the units of the model, or 0.1%, a part of "
                 "its diagonal",
                 text);
  if (rest.empty()) {
    check(value, length, option, text);
    return value;
  }
  value = hundredth_of(std::string_view(text).substr(0, text.size() - 1));
  check(value, part, option, text);
  return Distance::of_diagonal(value);
}

std::uint64_t count_in(const std::string& text, const std::string& option, std::uint64_t least,
                       std::uint64_t most, const char* words) {
  // Thousands are no help where only small numbers are taken.
  const std::string_view examples = most < 1'000'000 ? words : count_examples;
  const std::uint64_t value = whole_in(text, option, examples, 1000);
  if (value < least || value > most)
    throw Error(ErrorKind::usage, "`" + option + "` takes " + words + ", not " + grouped(value));
  return value;
}

std::uint64_t size_in(const std::string& text, const std::string& option) {
  return whole_in(text, option, size_examples, 1024);
}

void numbers_in(const std::string& text, const std::string& option, const char* examples,
                std::span<double> numbers) {
  std::size_t at = 0;
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    const std::size_t end = std::min(text.find(',', at), text.size());
    if (at > text.size() || (i + 1 == numbers.size()) != (end == text.size()))
      refuse_value(option, examples, text);
    const auto [behind, error] = std::from_chars(text.data() + at, text.data() + end, numbers[i]);
    if (error != std::errc{} || behind != text.data() + end || !std::isfinite(numbers[i]))
      refuse_value(option, examples, text);
    at = end + 1;
  }
}

std::vector<std::string> names_in(const std::string& text, const std::string& option) {
  std::vector<std::string> names{""};
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text[i] == ',') {
      names.emplace_back();
    } else {
      if (text[i] == '\\' && i + 1 < text.size()) ++i;
      names.back() += text[i];
    }
  }
  if (std::find(names.begin(), names.end(), "") != names.end())
    throw Error(ErrorKind::usage, "`" + option + "` '" + text +
                                      "' has an empty name; put one comma between two names");
  return names;
}

std::string text_of(const Distance& distance) {
  return distance.relative ? hundredfold(distance.value) + "%" : shortest(distance.value);
}

std::string text_of(std::span<const double> numbers) {
  std::string text;
  for (const double number : numbers) {
    if (!text.empty()) text += ',';
    text += shortest(number);
  }
  return text;
}

std::string text_of(const std::vector<std::string>& names) {
  std::string text;
  for (const std::string& name : names) {
    if (!text.empty()) text += ',';
    for (const char letter : name) {
      if (letter == ',' || letter == '\\') text += '\\';
      text += letter;
    }
  }
  return text;
}

}  // namespace winnow
