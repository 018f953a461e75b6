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

double square_beside_star(const Point& point, const Point& to, std::span<const StarFace> own,
                          std::span<const StarFace> others, const VertexPlaces& places,
                          double near) {
  double square = square_between(point, to);
  // What was collapsed into an end lies beside its faces, mostly.
  for (const std::span<const StarFace> faces : {own, others}) {
    for (const StarFace& face : faces) {
      if (square <= near) return square;
      if (!face.stays) continue;
      const Triangle left{to, places[face.w], places[face.x]};
      square = std::min(square, square_between(point, closest_point(point, left)));
    }
  }
  return square;
}

double WitnessPoints::near_square(const Point& to, double cost, double rounding) {
  return std::max(std::sqrt(cost / weight),
                  roundings * roundings * rounding * rounding * dot(to, to));
}

double WitnessPoints::farthest_at(double cost) {
  return std::sqrt(std::sqrt(cost / weight));
}

double WitnessPoints::cost_of(double square) {
  return weight * square * square;
}

WitnessPoints::WitnessPoints(const TileMesh& mesh, double rounding)
    : mesh_(mesh), rounding_(rounding), point_(mesh.vertex_count()) {
  for (VertexNumber v = 0; v < mesh.vertex_count(); ++v) point_[v] = mesh.position(v);
}

double WitnessPoints::cost(const Collapse& edge, const EdgeStar& star, double cost, bool flat) {
  const Point& to = edge.position;
  // As soon as both are this near, no more needs to be known.
  const double near = near_square(to, cost, rounding_);
  const VertexPlaces places = mesh_.places();
  const Point& of_kept = flat ? mesh_.position(edge.kept) : point_[edge.kept];
  const Point& of_removed = flat ? mesh_.position(edge.removed) : point_[edge.removed];
  double kept_square = mesh_.hub(edge.kept) ? 0 : square_between(of_kept, to);
  double removed_square = square_between(of_removed, to);
  if ((kept_square > near) | (removed_square > near)) {
    const auto [of_first, of_second] = star.squares_from(of_kept, of_removed);
    const auto nearest = [&](const Point& point, double square, double above, auto own,
                             auto others) {
      if (square <= near) return square;
      square = std::min(square, above);
      // Or an edge or a corner is nearest.
      if (square <= near) return square;
      return std::min(square, square_beside_star(point, to, own, others, places, near));
    };
    kept_square = nearest(of_kept, kept_square, of_first, star.of_kept(), star.of_removed());
    removed_square =
        nearest(of_removed, removed_square, of_second, star.of_removed(), star.of_kept());
  }
  square_ = std::max(kept_square, removed_square);
  const bool first = flat ? to == mesh_.position(edge.kept) : kept_square >= removed_square;
  next_ = point_[mesh_.hub(edge.kept) || first ? edge.kept : edge.removed];
  return square_ <= near ? cost : cost_of(square_);
}

}  // namespace winnow
