#include "cluster/cell_set.hpp"

#include "base/wide.hpp"

#include <algorithm>
#include <bit>
#include <utility>

namespace winnow {

namespace {

constexpr std::size_t least_slots = 1024;
constexpr unsigned filter_bits_a_slot = 8;

}  // namespace

CellSet::CellSet(Job& job) : job_(job) {
  grow();
}

void CellSet::grow() {
  const std::size_t slots = std::max(least_slots, 2 * slots_.size());
  const std::uint64_t bits = filter_bits_a_slot * slots;
  Reservation reserved = job_.budget.reserve(slots * sizeof(Slot) + bits / 8, "cells near damage");
  const std::vector<Slot> old = std::exchange(slots_, std::vector<Slot>(slots));
  filter_.assign(bits / 64, 0);
  filter_shift_ = 64 - static_cast<unsigned>(std::countr_zero(bits));
  reserved_ = std::move(reserved);
  size_ = 0;
  for (const Slot& slot : old) {
    if (slot.cell != empty) set(slot.cell, slot.number);
  }
}

std::size_t CellSet::slot_of(PackedCell cell) const {
  std::size_t at = scaled_hash(mixed_hash(cell), slots_.size());
  while (slots_[at].cell != empty && slots_[at].cell != cell)
    at = at + 1 == slots_.size() ? 0 : at + 1;
  return at;
}

void CellSet::set(PackedCell cell, unsigned number) {
  if (2 * size_ >= slots_.size()) grow();
  Slot& slot = slots_[slot_of(cell)];
  size_ += slot.cell == empty ? 1 : 0;
  slot = {cell, number};
  const std::uint64_t bit = quick_hash(cell) >> filter_shift_;
  filter_[bit >> 6] |= std::uint64_t{1} << (bit & 63);
}

}  // namespace winnow
