// How much area the removal of a vertex turns, and by how much, costlier where the vertex is
// important: the cost of M. Hussain, Y. Okada and K. Niijima, "Efficient and feature-preserving
// triangular mesh decimation" (2004), called MELOD. A vertex is removed into a neighbour, which
// stays where it is.
//
// What differs from the paper, by measurement (bench/RESULTS.md):
//
// - The angle by which a face turns is not replaced by 1 - cos, the paper's shortcut, but by 2 tan
//   of its half, which is the angle to within 6 % up to 45 degrees and takes no more time.
// - The importance is a slope. The paper's w = 1 - |k| falls with the square of the slope, so the
//   same distance costs the less the larger the faces are, and large blunt parts lose too much. By
//   the slope the cost goes with the square of the distance.
// - A boundary vertex costs the square of its distance from the line that is left. The paper adds
// the
//   length times the turn, which is no area, and its turn is that at the vertex that stays.
// - Costs do not accumulate. The paper raises the costs of the neighbours to that of the vertex
//   that goes. This is the least of all, so no vertex gets another turn by it.
#pragma once

#include "decimate/removal_cost.hpp"

#include <cstddef>

namespace winnow {

// How steep a vertex is: 0 where it is flat.
double visual_importance(const FanShape& shape);

// For every face that turns the mean of its area before and after, times its angle.
double turning_error(const FanView& fan, std::size_t into);

// Of the vertex of a fan.
class ImportanceOfRemoval {
 public:
  explicit ImportanceOfRemoval(const FanView& fan);
  double operator()(std::size_t into) const;
  // All of the area turns over.
  static double of_piece(const PieceLoss& loss);

 private:
  FanView fan_;
  double importance_;
  double boundary_ = 0;
};

using ImportanceCost = RemovalCost<ImportanceOfRemoval>;

}  // namespace winnow
