// Bytes compressed by deflate without a header: what browsers call deflate-raw.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace winnow {

// `ends`: where what is alike ends, in ascending order up to the size of `raw`; each part gets a
// code of its own.
std::vector<std::byte> deflated(std::span<const std::uint8_t> raw,
                                std::span<const std::size_t> ends);

// Throws Error(bad_input) where these are not `raw_bytes` bytes, or that is more than `most`.
std::vector<std::uint8_t> inflated(std::span<const std::byte> packed, std::uint32_t raw_bytes,
                                   std::uint32_t most);

}  // namespace winnow
