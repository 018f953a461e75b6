// The cells of a batch's corners, where nothing else is asked about them.
#pragma once

#include "base/morton.hpp"
#include "cluster/grid.hpp"
#include "cluster/kernel/position_kernel.hpp"
#include "read/face_batch.hpp"

#include <array>
#include <cstddef>
#include <cstdint>

namespace winnow {

class BatchCells {
 public:
  void find(const FaceBatch& faces, const Grid& grid);

  // Whether all corners of a face are on the lattice.
  [[nodiscard]] bool inside(std::size_t face) const {
    return (cell_[0][face] | cell_[1][face] | cell_[2][face]) >= 0;
  }
  // Of a face that is inside.
  [[nodiscard]] std::array<PackedCell, 3> of(std::size_t face) const {
    return {static_cast<PackedCell>(cell_[0][face]), static_cast<PackedCell>(cell_[1][face]),
            static_cast<PackedCell>(cell_[2][face])};
  }
  // As doubles. Valid as long as the batch.
  [[nodiscard]] const PositionInput& positions(std::size_t corner) const { return input_[corner]; }

 private:
  alignas(64) FaceBatch::Positions<double> position_{};
  alignas(64) std::array<std::array<std::int64_t, FaceBatch::capacity>, 3> cell_{};
  std::array<PositionInput, 3> input_{};
};

}  // namespace winnow
