#include "viewer/byte_range.hpp"

#include <algorithm>
#include <charconv>

namespace winnow::viewer {

namespace {

// A number that is all of the text.
std::optional<std::uint64_t> number(std::string_view text) {
  std::uint64_t value = 0;
  const char* end = text.data() + text.size();
  const auto [stopped, error] = std::from_chars(text.data(), end, value);
  if (text.empty() || error != std::errc() || stopped != end) return {};
  return value;
}

}  // namespace

std::optional<ByteRange> byte_range(std::string_view header, std::uint64_t bytes) {
  constexpr std::string_view unit = "bytes=";
  const ByteRange all{0, bytes, true};
  if (!header.starts_with(unit)) return all;
  header.remove_prefix(unit.size());
  const std::size_t dash = header.find('-');
  if (dash == std::string_view::npos) return all;
  const std::string_view first = header.substr(0, dash), last = header.substr(dash + 1);
  if (first.empty()) {  // so many at the end
    const auto count = number(last);
    if (!count) return all;
    if (*count == 0 || bytes == 0) return {};
    return ByteRange{bytes - std::min(*count, bytes), bytes, false};
  }
  const auto begin = number(first);
  const auto end = last.empty() ? std::optional(bytes) : number(last);
  if (!begin || !end || (!last.empty() && *end < *begin)) return all;
  if (*begin >= bytes) return {};
  return ByteRange{*begin, last.empty() ? bytes : std::min(bytes - 1, *end) + 1, false};
}

}  // namespace winnow::viewer
