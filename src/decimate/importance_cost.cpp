#include "decimate/importance_cost.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace winnow {

namespace {

// Of the square of a distance at a boundary: what the same distance costs on a surface, about.
constexpr double weight_of_boundary_square = 2;
// Needles that are steeper than this are all alike.
constexpr double least_cosine_of_slope = 0x1p-10;

}  // namespace

// Of a circular cone with this area, perimeter and slope: the height by the radius of the base, and
// by the cosine once more. Without that needles go too early. The tangent itself, which is the same
// for a circular cone, is larger where faces are long.
double visual_importance(const FanShape& shape) {
  if (!(shape.area > 0)) return 0;
  const double cosine = std::max(least_cosine_of_slope, shape.cosine());
  const double height = 2 * shape.area * shape.sine() / shape.perimeter;
  const double radius = std::sqrt(shape.area * cosine / std::numbers::pi);
  return height / (radius * cosine);
}

double turning_error(const FanView& fan, std::size_t into) {
  double error = 0;
  for_each_turned(fan, into, [&](const TurnedFace& face) {
    const double before = length(face.before);
    const double after = length(face.after);
    // As long as the cross product of the two normals, in which digits would cancel.
    const double across = length(face.side) * std::abs(face.swept);
    const double angle = 2 * across / (before * after + dot(face.before, face.after));
    error += (before + after) / 4 * angle;
  });
  return error;
}

ImportanceOfRemoval::ImportanceOfRemoval(const FanView& fan)
    : fan_(fan), importance_(visual_importance(shape_of(fan))) {
  if (fan.closed) return;
  const double height = boundary_height(fan);
  boundary_ = weight_of_boundary_square * height * height;
}

double ImportanceOfRemoval::of_piece(const PieceLoss& loss) {
  return std::numbers::pi * loss.area + weight_of_boundary_square * std::sqrt(loss.boundary);
}

double ImportanceOfRemoval::operator()(std::size_t into) const {
  return importance_ * turning_error(fan_, into) + boundary_;
}

}  // namespace winnow
