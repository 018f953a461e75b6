#include "decimate/importance_cost.hpp"

#include <algorithm>

namespace winnow {

namespace {

// Of the turn of a border, beside the areas of faces: the paper's lambda.
constexpr double border_weight = 10;
// Where nothing turns, as on flat parts, short edges go first. Far less than any error that can be seen.
constexpr double length_share = 1e-12;

}  // namespace

double visual_importance(std::span<const Point> seen, bool closed) {
  Point sum{};
  double total = 0;
  for (std::size_t i = 0; i < faces_of_fan(seen.size(), closed); ++i) {
    const Point doubled = cross(seen[i], seen[next_in_fan(i, seen.size())]);
    sum = sum + doubled;
    total += length(doubled);
  }
  return total > 0 ? std::max(0.0, 1 - length(sum) / total) : 0;
}

double turning_error(std::span<const Point> seen, bool closed, std::size_t into) {
  double error = 0;
  for (std::size_t i = 0; i < faces_of_fan(seen.size(), closed); ++i) {
    const std::size_t next = next_in_fan(i, seen.size());
    if (i == into || next == into) continue;
    const Point before = cross(seen[i], seen[next]);
    const Point after = cross(seen[i] - seen[into], seen[next] - seen[into]);
    const double size_before = length(before);
    const double size_after = length(after);
    // A face without an area has no direction to turn from.
    if (!(size_before > 0 && size_after > 0)) continue;
    const double cosine = dot(before, after) / (size_before * size_after);
    error += (size_before + size_after) / 4 * std::max(0.0, 1 - cosine);
  }
  return error;
}

// The paper prints phi12 = 1 - u21.u23 for the removal of v1 into v2, with the border's turn at v2, where it
// stays. So printed a straight border costs the most, 2, and no border is kept by fewer faces where it is
// straight, which is what the weight is for. What is lost is the turn at v1, which goes: that is 1 + u10.u12.
double border_turn(const Point& before, const Point& after) {
  return std::max(0.0, 1 + dot(unit(before), unit(after)));
}

ImportanceCost::Removal ImportanceCost::removal(VertexNumber v, double importance, std::size_t into) const {
  const std::span<const Point> seen = fan_.seen();
  const double error = turning_error(seen, fan_.closed(), into);
  const double square = dot(seen[into], seen[into]);
  double beside = length_share * square;
  // Not scaled by importance, which would cancel it on a flat sheet, and by the square of the length, where
  // the paper has the length: beside areas the result would depend on the unit.
  if (!fan_.closed()) beside += border_weight * border_turn(seen.front(), seen.back()) * square;
  return {importance * error + beside, importance * std::max(error, error_[v]) + beside};
}

Candidate ImportanceCost::best(VertexNumber v, const Candidate& after) {
  Candidate cheapest;
  if (mesh_.locked(v) || !fan_.find(mesh_, v)) return cheapest;
  const std::span<const VertexNumber> ring = fan_.neighbours();
  const double importance = visual_importance(fan_.seen(), fan_.closed());
  // What the vertex proposes is in the order of the new errors: the one that it remembers is the same for
  // all.
  const auto candidate = [&](std::size_t i) { return Candidate{removal(v, importance, i).order, ring[i]}; };
  Candidate last = Candidate::none_yet();
  const auto tried = std::find(ring.begin(), ring.end(), after.partner);
  if (after.price >= 0 && tried != ring.end())
    last = candidate(static_cast<std::size_t>(tried - ring.begin()));
  std::size_t best = 0;
  // A vertex at a border goes along that.
  const std::size_t step = fan_.closed() ? 1 : ring.size() - 1;
  for (std::size_t i = 0; i < ring.size(); i += step) {
    if (mesh_.locked(ring[i])) continue;
    const Candidate another = candidate(i);
    if (!last.before(another) || !another.before(cheapest)) continue;
    cheapest = another;
    best = i;
  }
  if (cheapest.exists()) cheapest.price = removal(v, importance, best).price;
  return cheapest;
}

PricedCollapse ImportanceCost::place(VertexNumber v, VertexNumber partner) const {
  // No dearer than offered: whatever changes a vertex's price makes it offer anew.
  return {{partner, v, mesh_.position(partner)}, 0};
}

// c_j = max(c_j, c_i) of the paper, for each neighbour j of the removed vertex i: c_j is what j costs now, so
// that it comes in where j is priced. Costs accumulate as they are before importance scales them.
void ImportanceCost::collapsing(const PricedCollapse& now) {
  const Collapse& edge = now.edge;
  ring_.clear();
  if (!fan_.find(mesh_, edge.removed)) return;
  const auto ring = fan_.neighbours();
  ring_.assign(ring.begin(), ring.end());
  const auto into = static_cast<std::size_t>(std::find(ring.begin(), ring.end(), edge.kept) - ring.begin());
  const double error = std::max(error_[edge.removed], turning_error(fan_.seen(), fan_.closed(), into));
  for (const VertexNumber w : ring_) error_[w] = error;
}

void ImportanceCost::collapsed(const Collapse& /*edge*/, Offers& offers) {
  for (const VertexNumber w : ring_) offers.set(w, best(w, Candidate::none_yet()));
}

}  // namespace winnow
