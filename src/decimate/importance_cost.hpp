// How much of the surface a collapse turns, and by how much: the cost of Hussain, Okada and Niijima (2004,
// "MELOD"), which keeps vertices of visual importance. A vertex is removed into a neighbour, which stays
// where it is.
#pragma once

#include "decimate/collapser.hpp"
#include "decimate/fan.hpp"

#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

namespace winnow {

// Of a vertex: 0 where its faces lie in one plane, 1 where their areas cancel out.
double visual_importance(std::span<const Point> seen, bool closed);

// Of removing the vertex of a fan into one of its neighbours: for every face that moves the mean of its area
// before and after, times 1 less the cosine of the angle by which it turns.
double turning_error(std::span<const Point> seen, bool closed, std::size_t into);

// How much a border turns at a vertex between these two: 0 where it is straight, 1 at a right angle, 2 where
// it goes back.
double border_turn(const Point& before, const Point& after);

class ImportanceCost {
 public:
  using State = double;

  // `errors`: of each vertex the state; zeros where nothing has been collapsed.
  ImportanceCost(TileMesh& mesh, std::vector<double> errors) : mesh_(mesh), error_(std::move(errors)) {}

  [[nodiscard]] Candidate best(VertexNumber v, const Candidate& after);
  [[nodiscard]] PricedCollapse place(VertexNumber v, VertexNumber partner) const;
  void collapsing(const PricedCollapse& now);
  void collapsed(const Collapse& edge, Offers& offers);

  [[nodiscard]] double state(VertexNumber v) const { return error_[v]; }
  [[nodiscard]] static double largest_error() { return 0; }  // not a distance

 private:
  struct Removal {
    double order = 0;  // of what one vertex proposes
    double price = 0;
  };
  // Into a neighbour of the vertex whose fan this is.
  [[nodiscard]] Removal removal(VertexNumber v, double importance, std::size_t into) const;

  TileMesh& mesh_;
  // What the last collapse beside each vertex came to, with what that remembered.
  std::vector<double> error_;
  Fan fan_;
  std::vector<VertexNumber> ring_;
};

}  // namespace winnow
