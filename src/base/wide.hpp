// 128-bit integers, for sums of sums.
#pragma once

#include <cstdint>

namespace winnow {

__extension__ using Int128 = __int128;
__extension__ using UInt128 = unsigned __int128;

// A whole number below `bound`, spread evenly over the values of `hash` (Lemire 2019).
constexpr std::uint64_t scaled_hash(std::uint64_t hash, std::uint64_t bound) {
  return static_cast<std::uint64_t>(static_cast<UInt128>(hash) * bound >> 64);
}

}  // namespace winnow
