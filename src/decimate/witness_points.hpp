// What planes do not notice: a needle, a fin or a tip is worn down from its end, collapse by
// collapse, while its faces stay in their planes. So every vertex keeps one point of the surface
// that was collapsed into it, one that was far from what took its place. (Klein, Liebich and
// Strasser 1996 keep all of them.)
#pragma once

#include "decimate/edge_star.hpp"
#include "decimate/tile_mesh.hpp"

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace winnow {

// The square of the distance of `point` from the faces that are left around an edge which collapses
// to `to`: no more than `near` where it is not above that. `own`: those of the end that keeps it.
double square_beside_star(const Point& point, const Point& to, std::span<const StarFace> own,
                          std::span<const StarFace> others, const VertexPlaces& places,
                          double near);

class WitnessPoints {
 public:
  // `rounding`: of positions (base/rounding.hpp). A point that is off by no more is not off.
  WitnessPoints(const TileMesh& mesh, double rounding);

  // Of a point that is off by so much; `square`: of the distance.
  static double cost_of(double square);
  // The farthest that a point can have been off beside a collapse at this cost.
  static double farthest_at(double cost);
  // The largest square of a distance that does not count: beside a collapse to `to` at this cost.
  static double near_square(const Point& to, double cost, double rounding);

  // The point that a vertex keeps, seen from it.
  [[nodiscard]] Point of(VertexNumber v) const { return point_[v] - mesh_.position(v); }
  void set(VertexNumber v, const Point& from_it) { point_[v] = mesh_.position(v) + from_it; }

  static constexpr std::uint64_t memory(std::uint64_t vertices) { return vertices * sizeof(Point); }

  // What it costs that the points of both ends would be so far from the faces left around the
  // collapsed edge: a multiple of the fourth power of the larger distance; `cost` where that is
  // not above it. `star`: the edge's, moved there. A hub keeps its own point, which is not looked
  // at. `flat`: the collapse goes to an end where nothing is lost. Then the ends themselves are
  // looked at, since the points of flat parts may lie beside faces that others have taken over.
  double cost(const Collapse& edge, const EdgeStar& star, double cost, bool flat);

  // The square of the larger distance of those that cost() was asked about last; no more than
  // rounding where it was not measured.
  [[nodiscard]] double square() const { return square_; }

  // To be told of the collapse that cost() was asked about last, before it is done.
  void collapsing(const Collapse& edge) { point_[edge.kept] = next_; }

 private:
  const TileMesh& mesh_;
  double rounding_;
  std::vector<Point> point_;
  Point next_{};
  double square_ = 0;
};

}  // namespace winnow
