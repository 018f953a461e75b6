// How far the vertex of a collapsed edge is from the planes of the faces that meet its two ends, each
// weighted by its area: the quadrics of Garland and Heckbert (1997), of the faces as they are now. That
// quadrics forget what was collapsed before (Lindstrom and Turk 1998) takes a quarter off the error at the
// same count (bench/RESULTS.md).
//
// Planes do not notice how a needle or a fin is worn down from its end: its faces stay in their planes. So
// where the normals around a vertex cancel each other, moving it costs besides.
#pragma once

#include "decimate/collapser.hpp"

#include <cmath>
#include <cstdint>
#include <vector>

namespace winnow {

class QuadricCost {
 public:
  // `single`: vertices go to numbers that floats have.
  QuadricCost(TileMesh& mesh, bool single);

  static constexpr std::uint64_t memory(std::uint64_t vertices) { return vertices * (sizeof(Planes) + 1); }

  [[nodiscard]] Candidate best(VertexNumber v, const Candidate& after);
  [[nodiscard]] PricedCollapse place(VertexNumber v, VertexNumber partner) const;
  void collapsing(const Collapse& edge);
  void collapsed(const Collapse& edge, Offers& offers);

  // The root of the mean squared distance of a vertex from the planes it was collapsed at, the largest there
  // was.
  [[nodiscard]] double largest_error() const { return std::sqrt(largest_square_); }

 private:
  // The sum of weight * n n' over planes through the vertex itself: the quadric has no other terms. And, of
  // the faces, the sum of weight * n.
  struct Planes {
    double xx = 0, xy = 0, xz = 0, yy = 0, yz = 0, zz = 0;
    Point normal{};

    [[nodiscard]] double weight() const { return xx + yy + zz; }

    void add(const Point& along, double weight) {
      xx += weight * along[0] * along[0];
      xy += weight * along[0] * along[1];
      xz += weight * along[0] * along[2];
      yy += weight * along[1] * along[1];
      yz += weight * along[1] * along[2];
      zz += weight * along[2] * along[2];
    }
  };

  void add_face(FaceNumber f, double sign);
  void add_border(FaceNumber f, const Point& doubled, double sign);
  void find_borders();
  // What moving the vertex by a length costs besides, with the square of that.
  [[nodiscard]] double wear(VertexNumber v) const;
  [[nodiscard]] PricedCollapse priced(VertexNumber low, VertexNumber high) const;

  TileMesh& mesh_;
  std::vector<Planes> planes_;
  std::vector<std::uint8_t> at_border_;  // may be; a vertex that is not is at none
  bool single_;
  double largest_square_ = 0;
};

}  // namespace winnow
