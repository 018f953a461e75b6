#include "numbers.hpp"

#include <winnow/error.hpp>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstdio>
#include <string_view>

namespace winnow::cli {

namespace {

[[noreturn]] void refuse(const std::string& option, const std::string& text, const char* examples) {
  throw Error(ErrorKind::usage, option + " takes " + examples + ", not '" + text + "'");
}

// The number at the front; `rest` is what follows it.
double parse_front(const std::string& option, const std::string& text, const char* examples,
                   std::string_view& rest) {
  double value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc{} || !std::isfinite(value)) refuse(option, text, examples);
  rest = std::string_view(end, static_cast<std::size_t>(text.data() + text.size() - end));
  return value;
}

std::uint64_t parse_scaled(const std::string& option, const std::string& text, const char* examples,
                           double step) {
  std::string_view rest;
  double value = parse_front(option, text, examples, rest);
  constexpr std::string_view units = "kMGT";
  if (!rest.empty()) {
    std::size_t unit = units.find(rest.front());
    if (rest.front() == 'K') unit = 0;
    if (rest.front() == 'm') unit = 1;
    if (rest.front() == 'g') unit = 2;
    if (unit == std::string_view::npos) refuse(option, text, examples);
    rest.remove_prefix(1);
    for (std::size_t i = 0; i <= unit; ++i) value *= step;
    if (step == 1024 && (rest == "iB" || rest == "ib" || rest == "B" || rest == "b")) rest = {};
    if (!rest.empty()) refuse(option, text, examples);
  }
  if (!(value >= 0 && value < 0x1p63)) refuse(option, text, examples);
  // 0.3G is a whole number that no double holds exactly on the way; 1.5 is none.
  if (std::abs(value - std::round(value)) > 1e-6 * value) refuse(option, text, examples);
  return static_cast<std::uint64_t>(std::llround(value));
}

template <typename... Values>
std::string format(const char* pattern, Values... values) {
  std::array<char, 64> text{};
  std::snprintf(text.data(), text.size(), pattern, values...);
  return text.data();
}

// Without its middle where it is longer; UTF-8 stays whole.
std::string shortened(const std::string& text, std::size_t longest) {
  if (text.size() <= longest) return text;
  const auto inside = [&](std::size_t at) {
    return (static_cast<unsigned char>(text[at]) & 0xC0) == 0x80;
  };
  std::size_t head = longest / 2, tail = text.size() - longest / 4;
  while (head > 0 && inside(head)) --head;
  while (tail < text.size() && inside(tail)) ++tail;
  return text.substr(0, head) + "..." + text.substr(tail);
}

}  // namespace

std::uint64_t parse_count(const std::string& option, const std::string& text) {
  return parse_scaled(option, text, "a count like 250000, 500k, 1.5M or 2G", 1000);
}

std::uint64_t parse_size(const std::string& option, const std::string& text) {
  return parse_scaled(option, text, "a size like 512M or 2G", 1024);
}

double parse_ratio(const std::string& option, const std::string& text) {
  constexpr const char* examples = "a ratio like 0.01 or 1%";
  std::string_view rest;
  const double value = parse_front(option, text, examples, rest);
  if (rest == "%") return value / 100;
  if (!rest.empty()) refuse(option, text, examples);
  return value;
}

double parse_length(const std::string& option, const std::string& text) {
  return parse_number(option, text, "a length like 2.5, a bare number in the units of the model");
}

Distance parse_distance(const std::string& option, const std::string& text) {
  constexpr const char* examples =
      "a distance like 0.5, a bare number in the units of the model, or 0.1%, a part of its "
      "diagonal";
  std::string_view rest;
  const double value = parse_front(option, text, examples, rest);
  if (rest == "%") return {value / 100, true};
  if (!rest.empty()) refuse(option, text, examples);
  return {value, false};
}

double parse_number(const std::string& option, const std::string& text, const char* examples) {
  std::string_view rest;
  const double value = parse_front(option, text, examples, rest);
  if (!rest.empty()) refuse(option, text, examples);
  return value;
}

namespace {

template <std::size_t count>
std::array<double, count> parse_numbers(const std::string& option, const std::string& text,
                                        const char* examples) {
  std::array<double, count> numbers{};
  std::size_t at = 0;
  for (std::size_t i = 0; i < count; ++i) {
    const std::size_t end = std::min(text.find(',', at), text.size());
    if (at > text.size() || (i + 1 == count) != (end == text.size()))
      refuse(option, text, examples);
    const auto [behind, error] = std::from_chars(text.data() + at, text.data() + end, numbers[i]);
    if (error != std::errc{} || behind != text.data() + end || !std::isfinite(numbers[i]))
      refuse(option, text, examples);
    at = end + 1;
  }
  return numbers;
}

}  // namespace

std::array<std::array<double, 3>, 2> parse_box(const std::string& option, const std::string& text) {
  const auto [a, b, c, d, e, f] = parse_numbers<6>(
      option, text, "six numbers like 0,0,0,10,10,5: the low and the high corner of a box");
  return {{{a, b, c}, {d, e, f}}};
}

std::array<double, 3> parse_triple(const std::string& option, const std::string& text,
                                   const char* examples) {
  return parse_numbers<3>(option, text, examples);
}

std::string clean(const std::string& text) {
  constexpr std::size_t longest_word = 300;
  constexpr std::size_t longest_text = 1500;
  std::string out, word;
  const auto end_word = [&] {
    out += shortened(word, longest_word);
    word.clear();
  };
  for (std::size_t i = 0; i < text.size(); ++i) {
    const auto byte = static_cast<unsigned char>(text[i]);
    const bool second_set = byte == 0xC2 && i + 1 < text.size() &&
                            static_cast<unsigned char>(text[i + 1]) < 0xA0;  // U+0080 to U+009F
    if (second_set) ++i;
    if (byte == ' ') end_word();
    word += second_set || byte < 0x20 || byte == 0x7F ? '?' : text[i];
  }
  end_word();
  return shortened(out, longest_text);
}

std::string show_list(const std::vector<std::string>& words) {
  std::string text;
  for (const std::string& word : words) text += (text.empty() ? "" : ", ") + word;
  return text;
}

std::string show_count(std::uint64_t count) {
  std::string digits = std::to_string(count);
  for (std::size_t at = digits.size(); at > 3;) {
    at -= 3;
    digits.insert(at, 1, ',');
  }
  return digits;
}

std::string show_bytes(std::uint64_t bytes) {
  constexpr std::array units{"bytes", "KiB", "MiB", "GiB", "TiB", "PiB", "EiB"};
  auto value = static_cast<double>(bytes);
  std::size_t unit = 0;
  for (; value >= 1000 && unit + 1 < units.size(); ++unit) value /= 1024;
  return format(unit == 0 || value >= 100 ? "%.0f " : "%.1f ", value) + units.at(unit);
}

std::string show_rate(double per_second) {
  if (per_second >= 1e9) return format("%.2f G", per_second / 1e9);
  if (per_second >= 1e6) return format("%.1f M", per_second / 1e6);
  if (per_second >= 1e3) return format("%.0f k", per_second / 1e3);
  return format("%.0f ", per_second);
}

std::string show_seconds(double seconds) {
  if (seconds < 10) return format("%.2f s", seconds);
  if (seconds < 120) return format("%.1f s", seconds);
  const auto whole = static_cast<std::uint64_t>(seconds + 0.5);
  if (whole < 7200) return std::to_string(whole / 60) + " min " + std::to_string(whole % 60) + " s";
  return std::to_string(whole / 3600) + " h " + std::to_string(whole % 3600 / 60) + " min";
}

std::string show_length(double length, int digits) {
  return format("%.*g", digits, length);
}

std::string show_place(const std::array<double, 3>& place, int digits) {
  return show_length(place[0], digits) + " " + show_length(place[1], digits) + " " +
         show_length(place[2], digits);
}

int digits_for(std::initializer_list<std::array<double, 3>> places, double size) {
  double farthest = 0;
  for (const auto& place : places) {
    for (const double x : place) farthest = std::max(farthest, std::abs(x));
  }
  const double more = size > 0 && farthest > size ? std::ceil(std::log10(farthest / size)) : 0;
  return 6 + static_cast<int>(std::min(more, 11.0));
}

std::string show_bad_faces(const BadFaces& bad) {
  std::string text = show_count(bad.total()) + " left out:";
  const char* separator = " ";
  for (const auto& [count, what] :
       {std::pair{bad.degenerate, "repeat a corner"},
        std::pair{bad.non_finite, "have a corner that is not finite"},
        std::pair{bad.out_of_range, "name a vertex that does not exist"}}) {
    if (count == 0) continue;
    text += separator + show_count(count) + " " + what;
    separator = ", ";
  }
  return text;
}

}  // namespace winnow::cli
