// Cells, each with a number.
#pragma once

#include "base/hash.hpp"
#include "base/morton.hpp"
#include "io/job.hpp"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace winnow {

// A hash table with a bit for each cell before it, as most cells that it is asked for are not in
// it.
class CellSet {
 public:
  explicit CellSet(Job& job);

  [[nodiscard]] std::size_t size() const { return size_; }
  [[nodiscard]] bool has(PackedCell cell) const { return number(cell) != 0; }

  // 0 where the cell is not in the set.
  [[nodiscard]] unsigned number(PackedCell cell) const {
    const std::uint64_t bit = quick_hash(cell) >> filter_shift_;
    if ((filter_[bit >> 6] >> (bit & 63) & 1) == 0) return 0;
    return slots_[slot_of(cell)].number;
  }
  // `number`: not 0.
  void set(PackedCell cell, unsigned number = 1);

 private:
  struct Slot {
    PackedCell cell = empty;
    unsigned number = 0;
  };
  static constexpr PackedCell empty = UINT64_MAX;

  [[nodiscard]] std::size_t slot_of(PackedCell cell) const;
  void grow();

  Job& job_;
  std::size_t size_ = 0;
  std::vector<Slot> slots_;
  std::vector<std::uint64_t> filter_;
  unsigned filter_shift_ = 0;
  Reservation reserved_;
};

}  // namespace winnow
