// How far the vertex of a collapsed edge is from the planes of the faces that meet its two ends, each
// weighted by its area: the quadrics of Garland and Heckbert (1997), of the faces as they are now. That
// quadrics forget what was collapsed before (Lindstrom and Turk 1998) takes a quarter off the error at the
// same count (bench/RESULTS.md). What is forgotten that way and must not be: farthest_points.hpp.
#pragma once

#include "decimate/collapser.hpp"
#include "decimate/edge_batch.hpp"
#include "decimate/farthest_points.hpp"

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace winnow {

class QuadricCost {
 public:
  // `single`: vertices go to numbers that floats have.
  QuadricCost(TileMesh& mesh, bool single);

  static constexpr std::uint64_t memory(std::uint64_t vertices) {
    return vertices * (sizeof(VertexPlanes) + 1) + FarthestPoints::memory(vertices);
  }

  [[nodiscard]] Candidate best(VertexNumber v, const Candidate& after);
  [[nodiscard]] PricedCollapse place(VertexNumber low, VertexNumber high);
  [[nodiscard]] double closer_price(const PricedCollapse& now, const EdgeStar& star, double price) {
    return farthest_.price(now.edge, star, price);
  }
  void collapsing(const PricedCollapse& now, const EdgeStar& star);
  void collapsed(const Collapse& edge, Offers& offers);

  // The root of the mean squared distance of a vertex from the planes it was collapsed at, the largest there
  // was.
  [[nodiscard]] double largest_error() const { return std::sqrt(largest_square_); }

 private:
  [[nodiscard]] VertexPlanes planes_of(FaceNumber f) const;
  [[nodiscard]] bool touches_border(FaceNumber f) const {
    const FaceVertices& face = mesh_.face(f);
    return at_border_[face[0]] + at_border_[face[1]] + at_border_[face[2]] >= 2;
  }
  void add_border(FaceNumber f, double sign);

  TileMesh& mesh_;
  std::vector<VertexPlanes> planes_;
  FarthestPoints farthest_;
  std::vector<std::uint8_t> at_border_;  // may be; a vertex that is not is at none
  EdgeKernel price_edges_;
  EdgeBatch batch_{};
  bool single_;
  double largest_square_ = 0;
  VertexPlanes planes_of_kept_;  // after the collapse
  bool near_border_ = false;     // the collapse is
};

}  // namespace winnow
