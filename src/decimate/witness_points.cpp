#include "decimate/witness_points.hpp"

#include "base/closest_point.hpp"

#include <algorithm>
#include <cmath>
#include <span>

namespace winnow {

namespace {

// The planes' cost is an area times the square of a distance. A point counts as a square as large
// as its distance: next to nothing where the surface is as near as it is elsewhere, much where the
// distance comes near the length of the edges. With less than this, tips are lost; with more, the
// error in the mean grows (bench/RESULTS.md).
constexpr double weight = 8;

// How many times the rounding of coordinates a point may be off: positions and the planes that they
// lie in are rounded, again and again.
constexpr double roundings = 4;

double square_between(const Point& a, const Point& b) {
  return dot(a - b, a - b);
}

}  // namespace

double WitnessPoints::cost_of(double square) {
  return weight * square * square;
}

WitnessPoints::WitnessPoints(const TileMesh& mesh, double rounding)
    : mesh_(mesh),
      rounding_square_(roundings * roundings * rounding * rounding),
      point_(mesh.vertex_count()) {
  for (VertexNumber v = 0; v < mesh.vertex_count(); ++v) point_[v] = mesh.position(v);
}

double WitnessPoints::cost(const Collapse& edge, const EdgeStar& star, double cost, bool flat) {
  const Point& to = edge.position;
  // As soon as both are this near, no more needs to be known.
  const double near = std::max(std::sqrt(cost / weight), rounding_square_ * dot(to, to));
  // What was collapsed into an end lies beside its faces, mostly.
  using Faces = std::span<const StarFace>;
  const auto square_left = [&](const Point& point, Faces own, Faces others) {
    double square = square_between(point, to);
    for (const Faces faces : {own, others}) {
      for (const StarFace& face : faces) {
        if (square <= near) return square;
        if (!face.stays) continue;
        const Triangle left{to, mesh_.position(face.w), mesh_.position(face.x)};
        square = std::min(square, square_between(point, closest_point(point, left)));
      }
    }
    return square;
  };
  const Point& of_kept = flat ? mesh_.position(edge.kept) : point_[edge.kept];
  const Point& of_removed = flat ? mesh_.position(edge.removed) : point_[edge.removed];
  const double kept_square =
      mesh_.hub(edge.kept) ? 0 : square_left(of_kept, star.of_kept(), star.of_removed());
  const double removed_square = square_left(of_removed, star.of_removed(), star.of_kept());
  square_ = std::max(kept_square, removed_square);
  const bool first = flat ? to == mesh_.position(edge.kept) : kept_square >= removed_square;
  next_ = point_[mesh_.hub(edge.kept) || first ? edge.kept : edge.removed];
  return square_ <= near ? cost : cost_of(square_);
}

}  // namespace winnow
