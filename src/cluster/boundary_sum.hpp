// Where the boundary of the surface runs through a cell: what its sides add up to.
#pragma once

#include "base/hash.hpp"
#include "base/morton.hpp"
#include "cluster/kernel/corner_kernel.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstdlib>
#include <vector>

namespace winnow {

// Sums over the directed sides a -> b of all faces that have an end in the cell (Lindstrom and
// Silva, "A memory insensitive technique for large model simplification", 2001). Where two faces
// meet, their sides cancel; so boundaries alone are left, whatever the order, without knowing which
// sides they are. Places are whole 2^-16 cells from the cell's middle. Sums wrap around.
struct BoundarySum {
  CellKey cell;                        // while it is in a BoundaryCache: the PackedCell
  std::array<std::int64_t, 3> along;   // b - a
  std::array<std::int64_t, 3> moment;  // a x b

  void add(const std::array<std::int64_t, 3>& more_along,
           const std::array<std::int64_t, 3>& more_moment) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      along[axis] = wrapped_sum(along[axis], more_along[axis]);
      moment[axis] = wrapped_sum(moment[axis], more_moment[axis]);
    }
  }
  // The same, number by number: written to memory first, they would stall where they are read
  // again.
  void add_side(std::int64_t u, std::int64_t v, std::int64_t w, std::int64_t x, std::int64_t y,
                std::int64_t z) {
    along[0] = wrapped_sum(along[0], u);
    along[1] = wrapped_sum(along[1], v);
    along[2] = wrapped_sum(along[2], w);
    moment[0] = wrapped_sum(moment[0], x);
    moment[1] = wrapped_sum(moment[1], y);
    moment[2] = wrapped_sum(moment[2], z);
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

// The sums of cells that faces fell into lately, for one thread. On a coherent mesh those away from
// boundaries are zero again before they give way, and leave nothing.
//
// The three sides of a face lead back to where they began, and their moments add up to twice its
// area, wherever a cell's middle is. So that is what a cell gets that holds two or three corners.
// A corner a that is alone in its cell gives it the sides a -> b and c -> a: c -> b together, with
// the moment a x (b - c).
class BoundaryCache {
 public:
  BoundaryCache() : slots_(std::size_t{1} << log_slots) {}

  static constexpr std::uint64_t bytes() { return sizeof(BoundarySum) << log_slots; }

  // The sum of a cell; take(sum) is called for one that gives way to it.
  template <typename Take>
  BoundarySum& sum_of(PackedCell cell, const Take& take) {
    BoundarySum& slot = slots_[quick_hash(cell) >> (64 - log_slots)];
    if (slot.cell != cell) {
      give(slot, take);
      slot = {};
      slot.cell = cell;
    }
    return slot;
  }

  // Adds the sides of a face of a batch that has two corners in one cell; `alone` is the third.
  template <typename Take>
  void add_pair(const CornerSums& faces, std::size_t i, std::size_t alone, const Take& take) {
    if (faces.far) return add_near_sides(faces, i, take);
    add_alone(faces, i, alone, take);
    add_area(faces, i, alone == 0 ? 1 : 0, take);
  }

  // The same of one with corners in three cells.
  template <typename Take>
  void add_across(const CornerSums& faces, std::size_t i, const Take& take) {
    if (faces.far) return add_near_sides(faces, i, take);
    for (std::size_t corner = 0; corner < 3; ++corner) add_alone(faces, i, corner, take);
  }

  // The same of any face, one by one. A side counts where it ends in the cell, but not where its
  // other end is far away: such a cell has no other boundary to be placed by.
  template <typename Take>
  void add_near_sides(const CornerSums& faces, std::size_t i, const Take& take) {
    const std::array<Steps, 3> at{steps_of(faces, i, 0), steps_of(faces, i, 1),
                                  steps_of(faces, i, 2)};
    for (std::size_t corner = 0; corner < 3; ++corner) {
      const std::size_t next = (corner + 1) % 3;
      const Steps along = difference(at[next], at[corner]);
      const auto add_side = [&](std::size_t inside) {
        const Steps middle = middle_of_cell(at[inside]);
        const Steps from = difference(at[corner], middle);
        if (!near(from) || !near(difference(at[next], middle))) return;
        sum_of(static_cast<PackedCell>(faces.cell[inside][i]), take)
            .add(along, crossed(from, along));
      };
      add_side(corner);
      if (faces.cell[next][i] != faces.cell[corner][i]) add_side(next);
    }
  }

  template <typename Take>
  void empty_into(const Take& take) {
    for (BoundarySum& slot : slots_) {
      give(slot, take);
      slot = {};
    }
  }

 private:
  using Steps = std::array<std::int64_t, 3>;

  static constexpr unsigned log_slots = 12;
  static constexpr std::int64_t half_cell = std::int64_t{1} << (side_bits - 1);
  // So that 2^22 sides are summed up without wrapping around.
  static constexpr std::int64_t farthest = std::int64_t{8} << side_bits;

  static std::int64_t step_of(std::int64_t place) { return place >> (fraction_bits - side_bits); }
  static Steps steps_of(const CornerSums& faces, std::size_t i, std::size_t corner) {
    return {step_of(faces.place[corner][0][i]), step_of(faces.place[corner][1][i]),
            step_of(faces.place[corner][2][i])};
  }
  static Steps middle_of_cell(const Steps& place) {
    const auto middle = [](std::int64_t at) { return (at >> side_bits << side_bits) + half_cell; };
    return {middle(place[0]), middle(place[1]), middle(place[2])};
  }
  static Steps difference(const Steps& a, const Steps& b) {
    return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
  }
  static Steps crossed(const Steps& a, const Steps& b) {
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
  }
  static bool near(const Steps& from_middle) {
    return std::abs(from_middle[0]) <= farthest && std::abs(from_middle[1]) <= farthest &&
           std::abs(from_middle[2]) <= farthest;
  }

  template <typename Take>
  void add_area(const CornerSums& faces, std::size_t i, std::size_t corner, const Take& take) {
    sum_of(static_cast<PackedCell>(faces.cell[corner][i]), take)
        .add({}, {faces.doubled_area[0][i], faces.doubled_area[1][i], faces.doubled_area[2][i]});
  }

  template <typename Take>
  void add_alone(const CornerSums& faces, std::size_t i, std::size_t corner, const Take& take) {
    const std::size_t next = corner == 2 ? 0 : corner + 1;
    const std::size_t last = corner == 0 ? 2 : corner - 1;
    const auto from_middle = [&](std::size_t axis) {
      constexpr std::int64_t in_cell = (std::int64_t{1} << side_bits) - 1;
      return (step_of(faces.place[corner][axis][i]) & in_cell) - half_cell;
    };
    const auto along = [&](std::size_t axis) {
      return step_of(faces.place[next][axis][i]) - step_of(faces.place[last][axis][i]);
    };
    BoundarySum& sum = sum_of(static_cast<PackedCell>(faces.cell[corner][i]), take);
    const std::int64_t x = from_middle(0), y = from_middle(1), z = from_middle(2);
    const std::int64_t u = along(0), v = along(1), w = along(2);
    sum.add_side(u, v, w, y * w - z * v, z * u - x * w, x * v - y * u);
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
