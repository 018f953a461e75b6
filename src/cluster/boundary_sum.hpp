// Where the boundary of the surface runs through a cell: what its sides add up to.
#pragma once

#include "base/hash.hpp"
#include "base/morton.hpp"

#include <array>
#include <cstdint>
#include <vector>

namespace winnow {

// Of each corner the place on the lattice, in whole 2^-22 cells (corner_kernel.hpp).
using LatticeFace = std::array<std::array<std::int64_t, 3>, 3>;

// Sums over the directed sides a -> b of all faces that have an end in the cell (Lindstrom and
// Silva, "A memory insensitive technique for large model simplification", 2001). Where two faces
// meet, their sides cancel; so boundaries alone are left, whatever the order, without knowing which
// sides they are. Places are whole 2^-16 cells from the cell's middle. Sums wrap around.
struct BoundarySum {
  CellKey cell;                        // while it is in a BoundaryCache: the PackedCell
  std::array<std::int64_t, 3> along;   // b - a
  std::array<std::int64_t, 3> moment;  // a x b

  void add(const BoundarySum& more);
  [[nodiscard]] bool empty() const {
    return (along[0] | along[1] | along[2] | moment[0] | moment[1] | moment[2]) == 0;
  }

  static bool before(const BoundarySum& a, const BoundarySum& b) { return a.cell < b.cell; }
  static bool combine(BoundarySum& into, const BoundarySum& from) {
    into.add(from);
    return true;
  }
};

// The place on the boundary's line that is nearest to `place`, both in cells from the middle; it
// keeps the area. `place` itself where no boundary passes through the cell.
std::array<double, 3> nearest_on_boundary(const BoundarySum& sum,
                                          const std::array<double, 3>& place);

// The sums of cells that faces fell into lately, for one thread. On a coherent mesh those away from
// boundaries are zero again before they give way, and leave nothing.
class BoundaryCache {
 public:
  BoundaryCache() : slots_(std::size_t{1} << log_slots) {}

  static constexpr std::uint64_t bytes() { return sizeof(BoundarySum) << log_slots; }

  // Adds the sides of a face, of which each corner has a cell and a place on the lattice. Calls
  // take(sum) for each sum that gives way.
  template <typename Take>
  void add(const std::array<PackedCell, 3>& cell, const LatticeFace& place, const Take& take) {
    add_to(cell[0], cell, place, take);
    if (cell[1] != cell[0]) add_to(cell[1], cell, place, take);
    if (cell[2] != cell[0] && cell[2] != cell[1]) add_to(cell[2], cell, place, take);
  }

  template <typename Take>
  void empty_into(const Take& take) {
    for (BoundarySum& slot : slots_) {
      give(slot, take);
      slot = {};
    }
  }

 private:
  static constexpr unsigned log_slots = 11;

  template <typename Take>
  void add_to(PackedCell of, const std::array<PackedCell, 3>& cell, const LatticeFace& place,
              const Take& take) {
    BoundarySum& slot = slots_[quick_hash(of) >> (64 - log_slots)];
    if (slot.cell != of) {
      give(slot, take);
      slot = {};
      slot.cell = of;
    }
    add_sides(of, cell, place, slot);
  }

  template <typename Take>
  static void give(BoundarySum sum, const Take& take) {
    if (sum.empty()) return;
    sum.cell = morton_key(PackedCell{sum.cell});
    take(sum);
  }

  static void add_sides(PackedCell of, const std::array<PackedCell, 3>& cell,
                        const LatticeFace& place, BoundarySum& sum);

  std::vector<BoundarySum> slots_;  // by PackedCell
};

}  // namespace winnow
