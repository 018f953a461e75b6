// Where in its cell the vertex of a cell goes.
#pragma once

#include "base/cell_state.hpp"
#include "base/quadric.hpp"
#include "base/wide.hpp"
#include "cluster/boundary_sum.hpp"
#include "cluster/cell_sum.hpp"
#include "cluster/clusterer.hpp"
#include "cluster/split_cells.hpp"
#include "mesh/vertex_index.hpp"

#include <array>

namespace winnow {

// The sums of one cell, or of one of those that it is split into, over all its entries.
class WholeCell {
 public:
  // `split`: what it is named by; null where no cell is split.
  WholeCell(CellKey key, const SplitCells* split);

  void add(const CellSum& sum);  // of the same cell
  void add(const QuadricCellSum& sum);
  void add(const BoundarySum& sum) { boundary_.add(sum.along, sum.moment); }

  [[nodiscard]] CellKey key() const { return key_; }
  [[nodiscard]] bool used() const { return used_; }  // by an output face

  // The mean of the corners, or, with quadrics, the point nearest to the planes; of that the
  // nearest on the boundary that passes through the cell, if one does. In its cell in any case, and
  // rounded to what will be written, so that two cells never share a position.
  [[nodiscard]] IndexedVertex vertex(const ClusterSettings& settings) const;

  // The planes of the cell's faces as a quadric in model units, seen from `position`. Cells do not
  // sum up the squares of the planes' distances; so the least value is taken to be 0, and costs
  // count from there.
  [[nodiscard]] Quadric quadric(const Grid& grid, const Point& position) const;
  // With the box of the cell, or of the part of one.
  [[nodiscard]] CellState state(const Grid& grid, const Point& position) const;

 private:
  [[nodiscard]] std::array<double, 3> mean_place() const;
  [[nodiscard]] std::array<double, 3> quadric_place(const std::array<double, 3>& mean) const;
  void keep_to_boundary(std::array<double, 3>& place) const;

  CellKey key_;
  SplitCells::Part part_;  // of its cell
  bool used_ = false;
  Int128 weight_ = 0;
  std::array<Int128, 3> position_{}, normal_{};
  std::array<Int128, 5> squares_{};
  std::array<Int128, 3> moment_{};
  BoundarySum boundary_{};
};

}  // namespace winnow
