// Integer hashing.
#pragma once

#include <cstdint>

namespace winnow {

// One multiplication; only the high bits are well mixed. For tables.
constexpr std::uint64_t quick_hash(std::uint64_t v) {
  return v * 0x9e3779b97f4a7c15;
}

// Every bit of the result depends on every bit of `v` (the finaliser of SplitMix64, Steele et al.
// 2014).
constexpr std::uint64_t mixed_hash(std::uint64_t v) {
  v += 0x9e3779b97f4a7c15;
  v = (v ^ v >> 30) * 0xbf58476d1ce4e5b9;
  v = (v ^ v >> 27) * 0x94d049bb133111eb;
  return v ^ v >> 31;
}

}  // namespace winnow
