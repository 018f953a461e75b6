// The volume that the removal of a vertex takes away or adds, costlier where the vertex is sharp:
// the cost of S. Guha, "Mesh simplification via a volume cost measure". A vertex is removed into a
// neighbour, which stays where it is.
//
// What differs from the paper, by measurement (bench/RESULTS.md):
//
// - The volume is the one that the collapse sweeps. The paper estimates it by the vertex alone, as
//   the angle times the cube of the height above the plane that fits the neighbours best. That is
//   not 0 along straight creases and bent sheets, where nothing is lost.
// - The neighbour is the one at which the volume is least, of those that are legal. The paper takes
//   an end of the line through two neighbours that passes closest to the vertex.
// - All vertices compete, and sharp ones pay more: the volume is divided by the angle. In the paper
//   those compete whose angle is at least the median of all, which a tile does not know.
// - The angle is that of the circular cone whose normals cancel out as much as those of the faces.
//   It is known where the paper's solid angle is not, at hyperbolic vertices: these may go as well.
// - A boundary counts by the area that it loses. The paper leaves boundaries open.
#pragma once

#include "decimate/removal_cost.hpp"

#include <cstddef>

namespace winnow {

// Between the faces as they are and as they would be.
double swept_volume(const FanView& fan, std::size_t into);

// The angle as a share of the half space: 1 where the vertex is flat, next to nothing at the tip of
// a needle.
double share_of_angle(const FanShape& shape);

// Of the vertex of a fan.
class VolumeOfRemoval {
 public:
  explicit VolumeOfRemoval(const FanView& fan);
  double operator()(std::size_t into) const;
  // The area times its distance from the middle of the piece, as if that were swept.
  static double of_piece(const PieceLoss& loss);

 private:
  FanView fan_;
  double share_;
  double boundary_ = 0;
};

using VolumeCost = RemovalCost<VolumeOfRemoval>;

}  // namespace winnow
