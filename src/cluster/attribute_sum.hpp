// What a cell, or a vertex, has of up to so many attributes: fixed-point sums beside CellSum's.
#pragma once

#include "base/morton.hpp"
#include "base/wide.hpp"
#include "cluster/cell_sum.hpp"

#include <array>
#include <cstddef>
#include <cstdint>

namespace winnow {

// The sum of weights stays under 2^41, as in CellSum, so that sums of 62-bit numbers stay under 2^103.
template <std::size_t Attributes>
struct AttributeSum {
  CellKey key;                                   // while it is in a FrontCache: the PackedCell
  std::uint64_t weight;                          // 0: this entry is empty
  std::array<std::uint64_t, Attributes> absent;  // the part of `weight` whose numbers are not finite
  std::array<Int128, Attributes> sum;            // weight times number

  [[nodiscard]] bool empty() const { return weight == 0; }
  [[nodiscard]] bool has_room(std::uint64_t more) const { return weight + more < CellSum::weight_bound; }

  static bool before(const AttributeSum& a, const AttributeSum& b) { return a.key < b.key; }

  // Adds `from`, of the same cell; false, and nothing done, where the sum could overflow.
  static bool combine(AttributeSum& into, const AttributeSum& from) {
    if (!into.has_room(from.weight)) return false;
    into.weight += from.weight;
    for (std::size_t i = 0; i < Attributes; ++i) {
      into.absent[i] += from.absent[i];
      into.sum[i] += from.sum[i];
    }
    return true;
  }
};

}  // namespace winnow
