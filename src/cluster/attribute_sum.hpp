// What a cell, or a vertex, has of up to so many attributes: fixed-point sums beside CellSum's.
#pragma once

#include "base/morton.hpp"
#include "base/wide.hpp"
#include "cluster/cell_sum.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>

namespace winnow {

// Whole numbers with a sign in the order of those without.
inline std::uint64_t biased(std::int64_t number) {
  return static_cast<std::uint64_t>(number) ^ (std::uint64_t{1} << 63);
}
inline std::int64_t unbiased(std::uint64_t number) {
  return static_cast<std::int64_t>(number ^ (std::uint64_t{1} << 63));
}

// The sum of weights stays under 2^41, as in CellSum, so that sums of 62-bit numbers stay under
// 2^103. Of a label there is no sum but its heaviest corner: the greatest number that has the
// corner's weight above the 64 bits of what the smallest label is the greatest of. It is `absent`
// everywhere, as a mark.
inline constexpr std::uint64_t label_mark = UINT64_MAX;

inline Int128 weighed_label(std::uint64_t weight, std::int64_t label) {
  return static_cast<Int128>(weight) << 64 | static_cast<Int128>(~biased(label));
}
inline std::int64_t label_of(Int128 weighed) {
  return unbiased(~static_cast<std::uint64_t>(weighed));
}

template <std::size_t Attributes>
struct AttributeSum {
  CellKey key;           // while it is in a FrontCache: the PackedCell
  std::uint64_t weight;  // 0: this entry is empty
  std::array<std::uint64_t, Attributes>
      absent;                          // the part of `weight` that has no number; or label_mark
  std::array<Int128, Attributes> sum;  // weight times number; or the heaviest label

  [[nodiscard]] bool empty() const { return weight == 0; }
  [[nodiscard]] bool has_room(std::uint64_t more) const {
    return weight + more < CellSum::weight_bound;
  }

  static bool before(const AttributeSum& a, const AttributeSum& b) { return a.key < b.key; }

  // Adds `from`, of the same cell; false, and nothing done, where the sum could overflow.
  static bool combine(AttributeSum& into, const AttributeSum& from) {
    if (!into.has_room(from.weight)) return false;
    into.add(from);
    return true;
  }

  // Whatever the weights.
  void add(const AttributeSum& from) {
    weight += from.weight;
    for (std::size_t i = 0; i < Attributes; ++i) {
      if (from.absent[i] == label_mark) {
        absent[i] = label_mark;
        sum[i] = std::max(sum[i], from.sum[i]);
      } else {
        absent[i] += from.absent[i];
        sum[i] += from.sum[i];
      }
    }
  }
};

}  // namespace winnow
