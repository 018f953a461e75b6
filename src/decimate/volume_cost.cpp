#include "decimate/volume_cost.hpp"

#include <algorithm>
#include <cmath>

namespace winnow {

namespace {

// Of the area that a boundary loses. With 1 boundaries shrink by more than surfaces do, with 100
// they keep a tenth of all faces (bench/RESULTS.md).
constexpr double weight_of_boundary_area = 10;
// Needles that are sharper than this share of the half space are all alike.
constexpr double sharpest = 0x1p-20;

}  // namespace

double swept_volume(const FanView& fan, std::size_t into) {
  double sum = 0;
  for_each_turned(fan, into, [&](const TurnedFace& face) { sum += std::abs(face.swept) / 6; });
  return sum;
}

// A circular cone of half the opening angle a takes 1 - cos a of the half space, and its faces
// slope by a right angle less a.
double share_of_angle(const FanShape& shape) {
  return std::max(sharpest, 1 - shape.sine());
}

VolumeOfRemoval::VolumeOfRemoval(const FanView& fan)
    : fan_(fan), share_(share_of_angle(shape_of(fan))) {
  if (fan.closed) return;
  // A triangle's mean distance from its side is a third of its height.
  const double height = boundary_height(fan);
  const double area = (length(fan.seen.front()) + length(fan.seen.back())) * height / 2;
  boundary_ = weight_of_boundary_area * area * height / 3;
}

double VolumeOfRemoval::of_piece(const PieceLoss& loss) {
  const double boundary = weight_of_boundary_area * std::pow(loss.boundary, 0.75);
  return std::sqrt(loss.area * loss.surface) + boundary;
}

double VolumeOfRemoval::operator()(std::size_t into) const {
  return (swept_volume(fan_, into) + boundary_) / share_;
}

}  // namespace winnow
