// What a grid cell knows of the surface in it: fixed-point sums, the same in whatever order they
// are made.
#pragma once

#include "base/morton.hpp"
#include "cluster/kernel/corner_kernel.hpp"

#include <array>
#include <cstdint>

namespace winnow {

// One cache line. The highest bit of `weight` says that an output face uses the cell; the sum below
// it stays under 2^41. A cell needing more has several entries, and the last merge adds them up in
// 128 bits.
struct alignas(64) CellSum {
  CellKey key;                           // while it is in a FrontCache: the PackedCell
  std::uint64_t weight;                  // units of 2^-24 cell areas; 0: this entry is empty
  std::array<std::int64_t, 3> position;  // weight times the place within the cell (22 bits)
  std::array<std::int64_t, 3> normal;    // weight times the unit normal (20 bits)

  static constexpr std::uint64_t used_bit = std::uint64_t{1} << 63;
  static constexpr std::uint64_t weight_bound = std::uint64_t{1} << 41;

  [[nodiscard]] bool empty() const { return weight == 0; }
  [[nodiscard]] bool has_room(std::uint64_t more) const {
    return (weight & ~used_bit) + more < weight_bound;
  }

  // Sums that are known to fit; the key and the highest bit of `weight` stay.
  void add(const CellSum& more) {
    weight += more.weight;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      position[axis] += more.position[axis];
      normal[axis] += more.normal[axis];
    }
  }
  void subtract(const CellSum& part) {
    weight -= part.weight;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      position[axis] -= part.position[axis];
      normal[axis] -= part.normal[axis];
    }
  }

  static bool before(const CellSum& a, const CellSum& b) { return a.key < b.key; }

  // Adds `from`, of the same cell; false, and nothing done, where the sum could overflow.
  static bool combine(CellSum& into, const CellSum& from) {
    if (!into.has_room(from.weight & ~used_bit)) return false;
    into.weight = ((into.weight & ~used_bit) + (from.weight & ~used_bit)) |
                  ((into.weight | from.weight) & used_bit);
    for (std::size_t axis = 0; axis < 3; ++axis) {
      into.position[axis] += from.position[axis];
      into.normal[axis] += from.normal[axis];
    }
    return true;
  }
};
static_assert(sizeof(CellSum) == 64);

// A CellSum with the summed plane quadrics of its faces beside it, seen from the middle of the
// cell: the squares of the unit normal (the sixth follows, they add up to the weight) and distance
// times normal.
struct alignas(64) QuadricCellSum : CellSum {
  std::array<std::int64_t, 5> squares;  // nx nx, nx ny, nx nz, ny ny, ny nz
  std::array<std::int64_t, 3> moment;

  void add(const QuadricCellSum& more) {
    CellSum::add(more);
    for (std::size_t i = 0; i < 5; ++i) squares[i] += more.squares[i];
    for (std::size_t i = 0; i < 3; ++i) moment[i] += more.moment[i];
  }
  void subtract(const QuadricCellSum& part) {
    CellSum::subtract(part);
    for (std::size_t i = 0; i < 5; ++i) squares[i] -= part.squares[i];
    for (std::size_t i = 0; i < 3; ++i) moment[i] -= part.moment[i];
  }

  static bool combine(QuadricCellSum& into, const QuadricCellSum& from) {
    if (!CellSum::combine(into, from)) return false;
    for (std::size_t i = 0; i < 5; ++i) into.squares[i] += from.squares[i];
    for (std::size_t i = 0; i < 3; ++i) into.moment[i] += from.moment[i];
    return true;
  }
};
static_assert(sizeof(QuadricCellSum) == 128);

// A face whose corners fell into three cells, by their keys in ascending order, and how often it
// did so: turned like the ascending order (an even permutation of it), or against it.
struct CellFace {
  std::array<CellKey, 3> cell;
  std::uint32_t along, against;

  // Written out: this decides how fast faces are sorted.
  static bool before(const CellFace& a, const CellFace& b) {
    if (a.cell[0] != b.cell[0]) return a.cell[0] < b.cell[0];
    if (a.cell[1] != b.cell[1]) return a.cell[1] < b.cell[1];
    return a.cell[2] < b.cell[2];
  }

  static bool combine(CellFace& into, const CellFace& from) {
    const std::uint64_t along = std::uint64_t{into.along} + from.along;
    const std::uint64_t against = std::uint64_t{into.against} + from.against;
    if (along > UINT32_MAX || against > UINT32_MAX) return false;
    into.along = static_cast<std::uint32_t>(along);
    into.against = static_cast<std::uint32_t>(against);
    return true;
  }
};
static_assert(sizeof(CellFace) == 32);

}  // namespace winnow
