#include "write/append_text.hpp"

#include <algorithm>
#include <cstring>
#include <limits>

namespace winnow {

namespace {

template <typename Number>
void append_as(std::vector<std::byte>& out, double value, ScalarType type) {
  std::array<std::byte, sizeof(Number)> stored;
  store_rounded(value, type, stored.data());
  Number number;
  std::memcpy(&number, stored.data(), sizeof number);
  append_number(out, number);
}

}  // namespace

void append_rounded(std::vector<std::byte>& out, double value, ScalarType type) {
  switch (type) {
    case ScalarType::int8:
      return append_as<std::int8_t>(out, value, type);
    case ScalarType::uint8:
      return append_as<std::uint8_t>(out, value, type);
    case ScalarType::int16:
      return append_as<std::int16_t>(out, value, type);
    case ScalarType::uint16:
      return append_as<std::uint16_t>(out, value, type);
    case ScalarType::int32:
      return append_as<std::int32_t>(out, value, type);
    case ScalarType::uint32:
      return append_as<std::uint32_t>(out, value, type);
    case ScalarType::float32:
      return append_as<float>(out, value, type);
    case ScalarType::float64:
      return append_as<double>(out, value, type);
  }
}

void append_real(std::vector<std::byte>& out, double value) {
  const std::size_t begin = out.size();
  constexpr double most = std::numeric_limits<float>::max();
  append_number(out, static_cast<float>(std::clamp(value, -most, most)));
  const bool whole = std::all_of(out.begin() + static_cast<std::ptrdiff_t>(begin), out.end(),
                                 [](std::byte b) { return b != std::byte{'.'} && b != std::byte{'e'}; });
  if (whole) append_text(out, ".0");
}

}  // namespace winnow
