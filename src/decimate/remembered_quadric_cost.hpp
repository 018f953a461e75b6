// The cost of Garland and Heckbert (1997): how far the collapsed edge's vertex is from the planes of all
// faces that it stands for, each weighted by its area.
#pragma once

#include "base/quadric.hpp"
#include "decimate/collapser.hpp"

#include <cmath>
#include <optional>
#include <utility>
#include <vector>

namespace winnow {

class RememberedQuadricCost {
 public:
  using State = Quadric;

  // `quadrics`: of each vertex, seen from it. `single`: vertices go to numbers that floats have. `error`: no
  // collapse may put a vertex farther than this from its planes, in the mean.
  RememberedQuadricCost(TileMesh& mesh, std::vector<Quadric> quadrics, bool single,
                        std::optional<double> error)
      : mesh_(mesh), quadric_(std::move(quadrics)), single_(single), error_(error) {}

  [[nodiscard]] Candidate best(VertexNumber v, const Candidate& after);
  [[nodiscard]] PricedCollapse place(VertexNumber low, VertexNumber high) const;
  void collapsing(const PricedCollapse& now);
  void collapsed(const Collapse& edge, Offers& offers);

  [[nodiscard]] const Quadric& state(VertexNumber v) const { return quadric_[v]; }

  // The root of the mean squared distance of a vertex from its planes, the largest there was.
  [[nodiscard]] double largest_error() const { return std::sqrt(largest_square_); }

 private:
  TileMesh& mesh_;
  std::vector<Quadric> quadric_;
  std::vector<VertexNumber> ring_;
  bool single_;
  std::optional<double> error_;
  double largest_square_ = 0;
};

}  // namespace winnow
