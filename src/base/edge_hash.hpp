// Edges by the positions of their ends.
#pragma once

#include "base/hash.hpp"
#include "base/vector.hpp"

#include <algorithm>
#include <bit>
#include <cstdint>

namespace winnow {

inline std::uint64_t position_hash(const Point& position) {
  std::uint64_t hash = 0;
  for (const double coordinate : position) {
    hash = mixed_hash(
        hash ^ std::bit_cast<std::uint64_t>(coordinate + 0.0));  // -0 and 0 are the same place
  }
  return hash;
}

// Of the hashes of its ends, in whatever order.
inline std::uint64_t edge_hash(std::uint64_t one_end, std::uint64_t other_end) {
  return mixed_hash(std::min(one_end, other_end) + std::rotl(std::max(one_end, other_end), 32));
}

}  // namespace winnow
