#include "decimate/remembered_quadric_cost.hpp"

#include <algorithm>
#include <limits>

namespace winnow {

namespace {

// Pulls the lowest point towards the middle of the edge where the planes leave it free, as a part of their
// weight.
constexpr double pull = 1e-3;
// Where planes cost nothing, as on flat parts, short edges go first.
constexpr double length_share = 1e-6;
constexpr double forbidden = std::numeric_limits<double>::infinity();

}  // namespace

RememberedQuadricCost::Placed RememberedQuadricCost::price(VertexNumber low, VertexNumber high) const {
  const Point edge = mesh_.position(high) - mesh_.position(low);
  // Both seen from `low`.
  Quadric sum = quadric_[high].from(-1.0 * edge);
  sum.add(quadric_[low]);
  const double weight = sum.weight();
  const Point middle = 0.5 * edge;
  Point t = middle;
  if (weight > 0) t = lowest_point(sum, pull * weight, middle);
  Point position = mesh_.position(low) + t;
  if (single_) {
    for (double& x : position) x = static_cast<double>(static_cast<float>(x));
  }
  if (!finite(position)) position = mesh_.position(low) + middle;
  const double error = std::max(0.0, sum.at(position - mesh_.position(low)));
  if (error_ && error > *error_ * *error_ * weight) return {forbidden, position};
  return {error + length_share * weight * dot(edge, edge), position};
}

Candidate RememberedQuadricCost::best(VertexNumber v, const Candidate& after) {
  Candidate cheapest;
  if (mesh_.locked(v)) return cheapest;
  // Every edge belongs to its lower end.
  mesh_.for_each_neighbour(v, [&](VertexNumber w) {
    if (w < v || mesh_.locked(w)) return;
    const Candidate candidate{price(v, w).price, w};
    if (candidate.price < forbidden && after.before(candidate) && candidate.before(cheapest))
      cheapest = candidate;
  });
  return cheapest;
}

PricedCollapse RememberedQuadricCost::place(VertexNumber v, VertexNumber partner) const {
  const Placed placed = price(v, partner);
  return {{v, partner, placed.position}, placed.price};
}

void RememberedQuadricCost::collapsing(const Collapse& edge) {
  Quadric sum = quadric_[edge.kept].from(edge.position - mesh_.position(edge.kept));
  sum.add(quadric_[edge.removed].from(edge.position - mesh_.position(edge.removed)));
  sum.c = std::max(0.0, sum.c);
  quadric_[edge.kept] = sum;
  if (sum.weight() > 0) largest_square_ = std::max(largest_square_, sum.c / sum.weight());
}

void RememberedQuadricCost::collapsed(const Collapse& edge, Offers& offers) {
  const VertexNumber kept = edge.kept;
  offers.set(kept, best(kept, Candidate::none_yet()));
  ring_.clear();
  mesh_.for_each_neighbour(kept, [&](VertexNumber w) {
    if (!mesh_.locked(w)) ring_.push_back(w);
  });
  for (const VertexNumber w : ring_) {
    const Candidate offered = offers.of(w);
    if (!offered.exists() || offered.partner == edge.removed || offered.partner == kept) {
      offers.set(w, best(w, Candidate::none_yet()));
    } else if (w < kept) {
      const Candidate candidate{price(w, kept).price, kept};
      if (candidate.before(offered)) offers.set(w, candidate);
    }
  }
}

}  // namespace winnow
