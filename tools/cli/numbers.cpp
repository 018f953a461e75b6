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
