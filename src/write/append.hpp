// Numbers as little-endian bytes.
#pragma once

#include <bit>
#include <cstddef>
#include <cstring>
#include <vector>

namespace winnow {

static_assert(std::endian::native == std::endian::little,
              "winnow is written for little-endian machines");

template <typename T>
void append(std::vector<std::byte>& out, T value) {
  const std::size_t at = out.size();
  out.resize(at + sizeof value);
  std::memcpy(out.data() + at, &value, sizeof value);
}

}  // namespace winnow
