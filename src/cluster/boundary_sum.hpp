// Where the boundary of the surface runs through a cell: what its sides add up to.
#pragma once

#include "base/hash.hpp"
#include "base/morton.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstdlib>
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

  static constexpr unsigned step_bits = 16;
  // Of a place in 2^-22 cells.
  static std::int64_t steps_of(std::int64_t place) { return place >> (22 - step_bits); }

  void add(const std::array<std::int64_t, 3>& more_along,
           const std::array<std::int64_t, 3>& more_moment) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      along[axis] = wrapped_sum(along[axis], more_along[axis]);
      moment[axis] = wrapped_sum(moment[axis], more_moment[axis]);
    }
  }
  [[nodiscard]] bool empty() const {
    return (along[0] | along[1] | along[2] | moment[0] | moment[1] | moment[2]) == 0;
  }

  static bool before(const BoundarySum& a, const BoundarySum& b) { return a.cell < b.cell; }
  static bool combine(BoundarySum& into, const BoundarySum& from) {
    into.add(from.along, from.moment);
    return true;
  }

 private:
  static std::int64_t wrapped_sum(std::int64_t a, std::int64_t b) {
    return static_cast<std::int64_t>(static_cast<std::uint64_t>(a) + static_cast<std::uint64_t>(b));
  }
};

// The place on the boundary's line that is nearest to `place`, both in cells from the middle; it
// keeps the area. `place` itself where no boundary passes through the cell.
std::array<double, 3> nearest_on_boundary(const BoundarySum& sum,
                                          const std::array<double, 3>& place);

// The directed sides of a face.
class Sides {
 public:
  explicit Sides(const LatticeFace& place) {
    std::int64_t longest = 0;
    for (std::size_t corner = 0; corner < 3; ++corner) {
      for (std::size_t axis = 0; axis < 3; ++axis)
        at_[corner][axis] = BoundarySum::steps_of(place[corner][axis]);
    }
    for (std::size_t side = 0; side < 3; ++side) {
      for (std::size_t axis = 0; axis < 3; ++axis) {
        along_[side][axis] = at_[(side + 1) % 3][axis] - at_[side][axis];
        longest = std::max(longest, std::abs(along_[side][axis]));
      }
    }
    short_ = longest < farthest - (std::int64_t{1} << step_bits);
  }

  // To the sum of the cell of the corner `inside`.
  void add(const std::array<PackedCell, 3>& cell, std::size_t inside, BoundarySum& sum) const {
    std::array<std::int64_t, 3> middle{};
    for (std::size_t axis = 0; axis < 3; ++axis)
      middle[axis] =
          (at_[inside][axis] >> step_bits << step_bits) + (std::int64_t{1} << (step_bits - 1));
    for (std::size_t side = 0; side < 3; ++side) {
      const std::size_t end = (side + 1) % 3;
      if (cell[side] != cell[inside] && cell[end] != cell[inside]) continue;
      // A side counts where it ends in the cell, but not where its other end is far away: such a
      // cell has no other boundary to be placed by.
      if (!short_ && !(near(at_[side], middle) && near(at_[end], middle))) continue;
      const std::array<std::int64_t, 3> from{at_[side][0] - middle[0], at_[side][1] - middle[1],
                                             at_[side][2] - middle[2]};
      sum.add(along_[side], crossed(from, along_[side]));
    }
  }

 private:
  using Steps = std::array<std::int64_t, 3>;

  static constexpr unsigned step_bits = BoundarySum::step_bits;
  // So that 2^22 sides are summed up without wrapping around.
  static constexpr std::int64_t farthest = std::int64_t{8} << step_bits;

  static bool near(const Steps& place, const Steps& middle) {
    bool all = true;
    for (std::size_t axis = 0; axis < 3; ++axis)
      all = all && std::abs(place[axis] - middle[axis]) <= farthest;
    return all;
  }
  static Steps crossed(const Steps& a, const Steps& b) {
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
  }

  std::array<Steps, 3> at_{};     // each corner
  std::array<Steps, 3> along_{};  // from each corner to the next
  bool short_ = false;
};

// The sums of cells that faces fell into lately, for one thread. On a coherent mesh those away from
// boundaries are zero again before they give way, and leave nothing.
class BoundaryCache {
 public:
  BoundaryCache() : slots_(std::size_t{1} << log_slots) {}

  static constexpr std::uint64_t bytes() { return sizeof(BoundarySum) << log_slots; }

  // The same of a face all in one cell, whose corners 1 and 2 lie by `u` and `v`, in steps,
  // from corner 0: its sides lead back to where they began, and their moments are twice its area,
  // wherever the cell's middle is.
  template <typename Take>
  void add_inside(PackedCell cell, const std::array<std::int64_t, 3>& u,
                  const std::array<std::int64_t, 3>& v, const Take& take) {
    std::array<std::int64_t, 3>& moment = slot_of(cell, take).moment;
    moment[0] += u[1] * v[2] - u[2] * v[1];
    moment[1] += u[2] * v[0] - u[0] * v[2];
    moment[2] += u[0] * v[1] - u[1] * v[0];
  }

  // Adds the sides of a face, of which each corner has a cell and a place on the lattice. Calls
  // take(sum) for each sum that gives way.
  template <typename Take>
  void add(const std::array<PackedCell, 3>& cell, const LatticeFace& place, const Take& take) {
    const Sides sides(place);
    sides.add(cell, 0, slot_of(cell[0], take));
    if (cell[1] != cell[0]) sides.add(cell, 1, slot_of(cell[1], take));
    if (cell[2] != cell[0] && cell[2] != cell[1]) sides.add(cell, 2, slot_of(cell[2], take));
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
  BoundarySum& slot_of(PackedCell cell, const Take& take) {
    BoundarySum& slot = slots_[quick_hash(cell) >> (64 - log_slots)];
    if (slot.cell != cell) {
      give(slot, take);
      slot = {};
      slot.cell = cell;
    }
    return slot;
  }

  template <typename Take>
  static void give(BoundarySum sum, const Take& take) {
    if (sum.empty()) return;
    sum.cell = morton_key(PackedCell{sum.cell});
    take(sum);
  }

  std::vector<BoundarySum> slots_;  // by PackedCell
};

}  // namespace winnow
