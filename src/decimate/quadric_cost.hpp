// How far the vertex of a collapsed edge is from the planes of the faces that meet its two ends, each
// weighted by its area: the quadrics of Garland and Heckbert (1997), of the faces as they are now. That
// quadrics forget what was collapsed before (Lindstrom and Turk 1998) takes a quarter off the error at the
// same count (bench/RESULTS.md).
//
// Planes do not notice how a needle or a fin is worn down from its end: its faces stay in their planes. So
// where the normals around a vertex cancel each other, moving it costs besides.
#pragma once

#include "decimate/collapser.hpp"
#include "decimate/kernel/edge_kernel.hpp"

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
    return vertices * (sizeof(VertexPlanes) + 1);
  }

  [[nodiscard]] Candidate best(VertexNumber v, const Candidate& after);
  [[nodiscard]] PricedCollapse place(VertexNumber low, VertexNumber high);
  void collapsing(const PricedCollapse& now);
  void collapsed(const Collapse& edge, Offers& offers);

  // The root of the mean squared distance of a vertex from the planes it was collapsed at, the largest there
  // was.
  [[nodiscard]] double largest_error() const { return std::sqrt(largest_square_); }

 private:
  [[nodiscard]] VertexPlanes planes_of(FaceNumber f, double sign) const;
  [[nodiscard]] bool touches_border(FaceNumber f) const {
    const FaceVertices& face = mesh_.face(f);
    return at_border_[face[0]] + at_border_[face[1]] + at_border_[face[2]] >= 2;
  }
  void add_border(FaceNumber f, double sign);
  // At a border the weight is not that of faces alone, and the planes there notice what wears down.
  [[nodiscard]] double wears(VertexNumber v) const { return at_border_[v] != 0 ? 0 : 1; }
  void begin_edges(VertexNumber low);
  void set_edge(std::size_t i, VertexNumber high);

  TileMesh& mesh_;
  std::vector<VertexPlanes> planes_;
  std::vector<std::uint8_t> at_border_;  // may be; a vertex that is not is at none
  EdgeKernel price_edges_;
  EdgeBatch batch_{};
  std::vector<VertexNumber> ends_;
  bool single_;
  double largest_square_ = 0;
};

}  // namespace winnow
