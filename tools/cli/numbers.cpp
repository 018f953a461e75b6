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

struct Character {
  std::uint32_t code = 0;  // of Unicode; 0 where the byte begins none
  std::size_t bytes = 1;
};

// The character of UTF-8 that begins there.
Character character_at(std::string_view text, std::size_t at) {
  const auto byte = [&](std::size_t i) {
    return at + i < text.size() ? static_cast<unsigned char>(text[at + i]) : 0U;
  };
  const std::uint32_t first = byte(0);
  if (first < 0x80) return {first, 1};
  const std::size_t bytes = first < 0xE0 ? 2 : first < 0xF0 ? 3 : 4;
  if (first < 0xC2 || first > 0xF4) return {};
  std::uint32_t code = first & (0x7FU >> bytes);
  for (std::size_t i = 1; i < bytes; ++i) {
    if ((byte(i) & 0xC0) != 0x80) return {};
    code = code << 6 | (byte(i) & 0x3F);
  }
  const std::uint32_t least = bytes == 2 ? 0x80 : bytes == 3 ? 0x800 : 0x10000;
  if (code < least || code > 0x10FFFF || (code >= 0xD800 && code < 0xE000)) return {};
  return {code, bytes};
}

// Whether it moves neither the cursor nor the text around it.
bool is_shown(std::uint32_t code) {
  const bool control = code < 0x20 || (code >= 0x7F && code < 0xA0);
  const bool line_end = code == 0x2028 || code == 0x2029;
  const bool turns = (code >= 0x202A && code <= 0x202E) || (code >= 0x2066 && code <= 0x2069);
  return !control && !line_end && !turns;
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
  for (std::size_t i = 0; i < text.size();) {
    const auto [code, bytes] = character_at(text, i);
    if (code == ' ') end_word();
    word += is_shown(code) ? text.substr(i, bytes) : "?";
    i += bytes;
  }
  end_word();
  return shortened(out, longest_text);
}

std::string escaped_json(const std::string& json) {
  std::string out;
  for (std::size_t i = 0; i < json.size();) {
    const auto [code, bytes] = character_at(json, i);
    out += is_shown(code) || code == '\n' ? json.substr(i, bytes) : format("\\u%04x", code);
    i += bytes;
  }
  return out;
}

std::string show_list(const std::vector<std::string>& words) {
  std::string text;
  for (const std::string& word : words) text += (text.empty() ? "" : ", ") + word;
  return text;
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

std::string show_resumed(const Resumed& resumed) {
  if (resumed.written) return "all was done";
  if (!resumed.clustered) return "nothing was done yet";
  std::string text = "the input was read";
  if (resumed.rounds > 0)
    text +=
        ", " + grouped(resumed.rounds) + (resumed.rounds == 1 ? " round" : " rounds") + " refined";
  if (resumed.tiles > 0)
    text += ", " + grouped(resumed.tiles) + (resumed.tiles == 1 ? " tile" : " tiles") +
            " of the next tried";
  return text;
}

std::string show_bad_faces(const BadFaces& bad) {
  std::string text = grouped(bad.total()) + " left out:";
  const char* separator = " ";
  for (const auto& [count, what] :
       {std::pair{bad.degenerate, "repeat a corner"},
        std::pair{bad.non_finite, "have a corner that is not finite"},
        std::pair{bad.out_of_range, "name a vertex that does not exist"}}) {
    if (count == 0) continue;
    text += separator + grouped(count) + " " + what;
    separator = ", ";
  }
  return text;
}

}  // namespace winnow::cli
