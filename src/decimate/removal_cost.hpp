// Vertices that are removed into a neighbour, which stays where it is: what the costs that do so
// have in common.
#pragma once

#include "decimate/collapser.hpp"
#include "decimate/fan.hpp"
#include "decimate/legality.hpp"
#include "decimate/piece.hpp"

#include <cstddef>
#include <span>
#include <vector>

namespace winnow {

// Removal(view)(i): what the removal of a fan's vertex into its neighbour i costs, by the fan
// alone; 0 where nothing is lost. Removal::of_piece(loss): what it costs that a piece goes.
template <typename Removal>
class RemovalCost {
 public:
  // `rounding`: of positions (base/rounding.hpp). `free_topology`: vertices whose faces are no fan
  // may go, too.
  RemovalCost(TileMesh& mesh, double rounding, bool free_topology)
      : mesh_(mesh), fan_(rounding), free_(free_topology) {}

  [[nodiscard]] Candidate best(VertexNumber v, const Candidate& after) {
    Candidate cheapest;
    if (!fan_.find(mesh_, v) && !(free_ && fan_.find_loose(mesh_, v))) return cheapest;
    const FanView view = fan_.view();
    const Removal cost(view);
    // A vertex at a boundary goes along that.
    const std::size_t step = view.closed ? 1 : view.seen.size() - 1;
    for (std::size_t i = 0; i < view.seen.size(); i += step) {
      const VertexNumber w = fan_.neighbours()[i];
      if (mesh_.closed(w)) continue;
      const double lost = cost(i);
      const Candidate candidate{lost > 0 ? lost : flat_cost(view, i), w};
      if (after.before(candidate) && candidate.before(cheapest)) cheapest = candidate;
    }
    return cheapest;
  }

  // No costlier than offered: whatever changes a fan makes its vertex offer anew.
  [[nodiscard]] EvaluatedCollapse place(VertexNumber v, VertexNumber partner) const {
    return {{partner, v, mesh_.position(partner)}, 0};
  }

  [[nodiscard]] double cost_of_piece(const TileMesh& mesh, const Piece& piece) const {
    return Removal::of_piece(loss_of(mesh, piece));
  }

  [[nodiscard]] double cost_of_change(const EdgeStar& star, const Collapse& edge,
                                      const SurfaceChange& change) const {
    return Removal::of_piece(loss_of(mesh_, star, edge, change));
  }
  [[nodiscard]] double cost_of_turning(const EdgeStar& star, const Collapse& edge) const {
    return Removal::of_piece(loss_by_turning(mesh_, star, edge));
  }
  void faces_gone(std::span<const FaceVertices> faces, Offers& offers) const {
    for (const FaceVertices& face : faces) {
      for (const VertexNumber v : face) offers.make_stale(v);
    }
  }

  void collapsing(const EvaluatedCollapse& now) {
    const auto ring = mesh_.neighbours(now.edge.removed);
    ring_.assign(ring.begin(), ring.end());
  }
  void collapsed(const Collapse& /*edge*/, Offers& offers) {
    for (const VertexNumber w : ring_) offers.set(w, best(w, Candidate::none_yet()));
  }

  [[nodiscard]] static double largest_error() { return 0; }  // not a distance

 private:
  TileMesh& mesh_;
  Fan fan_;
  bool free_;
  std::vector<VertexNumber> ring_;
};

}  // namespace winnow
