// The bytes of a file that a request asks for: the header Range of HTTP.
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

namespace winnow::viewer {

struct ByteRange {
  std::uint64_t begin = 0, end = 0;
  bool whole = true;  // nothing else was asked for, or several parts, which are not given
};

// Of a file of so many bytes. Nothing where none of the bytes asked for are there.
std::optional<ByteRange> byte_range(std::string_view header, std::uint64_t bytes);

}  // namespace winnow::viewer
