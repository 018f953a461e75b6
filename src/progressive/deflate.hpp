// Bytes compressed by deflate without a header: what browsers call deflate-raw.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace winnow {

std::vector<std::byte> deflated(std::span<const std::uint8_t> raw);

// Throws Error(bad_input) where these are not `raw_bytes` bytes, or that is more than `most`.
std::vector<std::uint8_t> inflated(std::span<const std::byte> packed, std::uint32_t raw_bytes,
                                   std::uint32_t most);

}  // namespace winnow
