#include "decimate/remembered_quadric_cost.hpp"

#include "decimate/quadric_placement.hpp"

#include <algorithm>
#include <limits>

namespace winnow {

namespace {

// Pulls the lowest point towards the middle of the edge.
constexpr double pull_of_remembered = 1e-3;
constexpr double forbidden = std::numeric_limits<double>::infinity();

}  // namespace

PricedCollapse RememberedQuadricCost::place(VertexNumber low, VertexNumber high) const {
  const Point edge = mesh_.position(high) - mesh_.position(low);
  // Both seen from `low`.
  Quadric sum = quadric_[high].from(-1.0 * edge);
  sum.add(quadric_[low]);
  const double weight = sum.weight();
  const Point position = lowest_position(sum, pull_of_remembered, mesh_.position(low), edge, single_);
  const double error = std::max(0.0, sum.at(position - mesh_.position(low)));
  const bool allowed = !error_ || error <= *error_ * *error_ * weight;
  return {{low, high, position}, allowed ? error + edge_length_share * weight * dot(edge, edge) : forbidden};
}

Candidate RememberedQuadricCost::best(VertexNumber v, const Candidate& after) {
  Candidate cheapest;
  if (mesh_.locked(v)) return cheapest;
  for (const VertexNumber w : mesh_.owned_edges(v)) {
    const Candidate candidate{place(v, w).price, w};
    if (candidate.price < forbidden && after.before(candidate) && candidate.before(cheapest))
      cheapest = candidate;
  }
  return cheapest;
}

void RememberedQuadricCost::collapsing(const PricedCollapse& now) {
  const Collapse& edge = now.edge;
  Quadric sum = quadric_[edge.kept].from(edge.position - mesh_.position(edge.kept));
  sum.add(quadric_[edge.removed].from(edge.position - mesh_.position(edge.removed)));
  sum.c = std::max(0.0, sum.c);
  quadric_[edge.kept] = sum;
  if (sum.weight() > 0) largest_square_ = std::max(largest_square_, sum.c / sum.weight());
}

void RememberedQuadricCost::collapsed(const Collapse& edge, Offers& offers) {
  const VertexNumber kept = edge.kept;
  offers.set(kept, best(kept, Candidate::none_yet()));
  const auto neighbours = mesh_.neighbours(kept);
  ring_.assign(neighbours.begin(), neighbours.end());
  for (const VertexNumber w : ring_) {
    if (mesh_.locked(w)) continue;
    const Candidate offered = offers.of(w);
    if (!offered.exists() || offered.partner == edge.removed || offered.partner == kept) {
      offers.set(w, best(w, Candidate::none_yet()));
    } else if (w < kept) {
      const Candidate candidate{place(w, kept).price, kept};
      if (candidate.before(offered)) offers.set(w, candidate);
    }
  }
}

}  // namespace winnow
