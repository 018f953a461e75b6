#include "write/append_text.hpp"

#include <algorithm>
#include <cstring>

namespace winnow {

void append_rounded(std::vector<std::byte>& out, double value, NumberType type) {
  with_type(type, [&]<typename Number>(Number number) {
    std::array<std::byte, sizeof number> stored;
    store_rounded(value, type, stored.data());
    std::memcpy(&number, stored.data(), sizeof number);
    append_number(out, number);
  });
}

void append_real(std::vector<std::byte>& out, double value) {
  const std::size_t begin = out.size();
  append_rounded(out, value, NumberType::float32);
  const bool whole =
      std::all_of(out.begin() + static_cast<std::ptrdiff_t>(begin), out.end(),
                  [](std::byte b) { return b != std::byte{'.'} && b != std::byte{'e'}; });
  if (whole) append_text(out, ".0");
}

}  // namespace winnow
