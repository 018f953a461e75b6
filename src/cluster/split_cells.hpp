// Cells that are cut into smaller ones, because clustering damaged the surface in them.
#pragma once

#include "base/morton.hpp"
#include "base/vector.hpp"
#include "cluster/cell_set.hpp"
#include "cluster/grid.hpp"
#include "cluster/kernel/corner_kernel.hpp"
#include "io/job.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

namespace winnow {

// A part of depth d is one of the 8^d equal ones of its cell. All parts are named on one lattice,
// 2^bits() times as fine as that of the cells: by the lowest place in them. So names have the order
// of keys, and those of a cell follow each other.
class SplitCells {
 public:
  // `box`: of everything that is clustered.
  SplitCells(Job& job, const Grid& grid, const Box& box);

  // The finest depth that the lattice has room for.
  [[nodiscard]] unsigned bits() const { return bits_; }
  // Cells that are split.
  [[nodiscard]] std::size_t size() const { return first_.size(); }

  // Splits a cell that is not split, at least so deep.
  void split(PackedCell cell, unsigned depth);
  // Splits what has this name, a cell or a part of one. False, and nothing done, if that is the
  // finest.
  bool split_further(CellKey name);

  // The name of what has this position, a cell or a part of one.
  [[nodiscard]] CellKey name_at(const Grid& grid, const Point& position) const;
  // The cell of a name.
  [[nodiscard]] PackedCell cell_of(CellKey name) const;
  // The name of a cell that is not split.
  [[nodiscard]] CellKey name_of(CellKey cell) const { return cell << (3 * bits_); }

  // Where a name's part of its cell begins on an axis, and how long it is, in cells.
  struct Part {
    std::array<std::uint32_t, 3> cell{};
    std::array<double, 3> low{};
    double size = 1;
    unsigned depth = 0;
  };
  [[nodiscard]] Part part_of(CellKey name) const;

  // The name of a position whose part is of the finest depth; nothing elsewhere.
  [[nodiscard]] std::optional<CellKey> finest_part(const Point& position) const;

  // Gives each corner the name that it has on the fine lattice in place of its cell, and each face
  // the kind that follows.
  void rename(CornerSums& corners, std::size_t count) const;

 private:
  // In this order a part becomes finer while it has to. At first it hardly ever takes more than one
  // step.
  static constexpr std::array<unsigned, 8> depths{1, 2, 3, 4, 6, 8, 12, 16};

  // Of what is at a place of the fine lattice the step it has got to; 0: its cell is not split.
  [[nodiscard]] unsigned step_at(const std::array<std::uint32_t, 3>& place) const;
  [[nodiscard]] unsigned depth_of(unsigned step) const {
    return step == 0 ? 0 : std::min(depths[step - 1], bits_);
  }
  [[nodiscard]] PackedCell part_at(const std::array<std::uint32_t, 3>& place,
                                   unsigned depth) const {
    const unsigned below = bits_ - depth;
    return pack_cell(place[0] >> below << below, place[1] >> below << below,
                     place[2] >> below << below);
  }

  Grid grid_;
  unsigned bits_ = 0;
  CellSet first_;                 // the step of a cell's coarsest parts
  std::vector<CellSet> further_;  // of each step the parts that went on from it
};

}  // namespace winnow
