// A small table before the big one: what neighbouring faces add to the same cells stays in the
// core's own cache, and the big table sees one addition in many.
#pragma once

#include "base/hash.hpp"
#include "cluster/cell_sum.hpp"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace winnow {

// Direct-mapped; one for each thread.
template <typename Sum>
class FrontCache {
 public:
  static constexpr unsigned index_bits = 12;
  static constexpr std::size_t bytes = sizeof(Sum) << index_bits;

  FrontCache() : lines_(std::size_t{1} << index_bits) {}

  // The entry of `cell`, with room for `weight` more. An entry that has to go is handed to
  // `evict`.
  template <typename GiveWay>
  Sum& entry(PackedCell cell, std::uint64_t weight, GiveWay&& evict) {
    Sum& line = lines_[quick_hash(cell) >> (64 - index_bits)];
    if (__builtin_expect(line.key != cell || !line.has_room(weight) || line.empty(), 0)) {
      if (!line.empty()) evict(line);
      line = {};
      line.key = cell;
    }
    return line;
  }

  template <typename GiveWay>
  void empty_into(GiveWay&& evict) {
    for (Sum& line : lines_) {
      if (!line.empty()) evict(line);
      line = {};
    }
  }

 private:
  std::vector<Sum> lines_;
};

}  // namespace winnow
