#include "decimate/sequence_cost.hpp"

#include "decimate/edge_feature.hpp"
#include "decimate/witness_points.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <span>

namespace winnow {

namespace {

// Part of the loss by turning (legality.hpp) that a frame counts in which a face has to turn by
// more than it may. Measured on four of 100 frames of a chicken at a tenth of the faces: without
// such collapses the RMS is twice that of each frame alone, with 0.1 it is 1.24 times that, with
// 0.02 1.14 times and with 0.01 1.09 times. There more of it flips no fewer faces.
constexpr double turning_weight = 0.01;
// A piece costs as much as a point does that is off by 1.2 times the distance of its farthest
// vertex from its middle (squared here). `simplify` asks for six times that distance. With it the
// chicken at 3 % kept one stuck piece, with a third of the faces and a fiftieth of the area: the
// RMS was 1.26 times as large. With 1 times the distance it is 1.17 times as large at 1 %.
constexpr double piece_excess = 1.44;
// No collapse turns a face by more than 90 degrees.
constexpr double least_cosine_at_a_cost = 0;

}  // namespace

SequenceCost::SequenceCost(TileMesh& mesh, Frames& frames, std::span<const std::byte> state,
                           const DecimationSettings& settings)
    : mesh_(mesh),
      frames_(frames),
      settings_(*settings.sequence),
      single_(settings.single),
      least_cosine_(settings.least_cosine),
      quadrics_(make_frame_quadrics(mesh, frames, state, settings)),
      edge_(frames.count()),
      beside_(mesh) {}

double SequenceCost::feature_weight(VertexNumber low, VertexNumber high) {
  if (settings_.feature_weight == 0 || mesh_.hub(low) || mesh_.hub(high)) return 0;
  const double first = feature_of(mesh_, frames_.places(0), low, high).weight;
  const double last = feature_of(mesh_, frames_.places(frames_.count() - 1), low, high).weight;
  return (first + last) / 2;
}

double SequenceCost::sum_of_costs(double feature) const {
  const double sum = std::accumulate(edge_.costs.begin(), edge_.costs.end(), 0.0);
  double all = (1 + settings_.feature_weight * feature) * sum;
  if (settings_.deformation_weight == 0) return all;
  const double mean = sum / static_cast<double>(edge_.costs.size());
  double deformation = 0;
  for (const double cost : edge_.costs) deformation += std::abs(cost - mean);
  return all + settings_.deformation_weight * deformation;
}

Candidate SequenceCost::best(VertexNumber v, const Candidate& after) {
  Candidate cheapest;
  if (mesh_.locked(v)) return cheapest;
  const std::span<const VertexNumber> ends = mesh_.owned_edges(v);
  ends_.assign(ends.begin(), ends.end());
  for (const VertexNumber end : ends_) {
    quadrics_->evaluate(v, end, edge_);
    const Candidate candidate{sum_of_costs(feature_weight(v, end)), end};
    if (after.before(candidate) && candidate.before(cheapest)) cheapest = candidate;
  }
  return cheapest;
}

EvaluatedCollapse SequenceCost::place(VertexNumber low, VertexNumber high) {
  quadrics_->evaluate(low, high, edge_);
  feature_ = feature_weight(low, high);
  const double cost = sum_of_costs(feature_);
  if (!mesh_.hub(high)) return {{low, high, edge_.to.front()}, cost};
  const std::span<const Point> stays = frames_.positions(high);
  edge_.to.assign(stays.begin(), stays.end());
  return {{high, low, edge_.to.front()}, cost};
}

bool SequenceCost::keeps_faces(const Legality& legality, EdgeStar& star, EvaluatedCollapse& now) {
  bool otherwise = false;
  for (std::size_t t = 0; t < frames_.count(); ++t) {
    const Collapse edge{now.edge.kept, now.edge.removed, edge_.to[t]};
    if (legality.keeps_faces(star, edge, frames_.places(t))) continue;
    if (!place_otherwise(t, legality, star, edge)) return false;
    otherwise = true;
  }
  now.edge.position = edge_.to.front();
  if (otherwise) now.cost = sum_of_costs(feature_);
  return true;
}

bool SequenceCost::place_otherwise(std::size_t frame, const Legality& legality, EdgeStar& star,
                                   const Collapse& edge) {
  if (mesh_.hub(edge.kept)) return false;
  struct Place {
    Point at;
    double cost;
    bool flat = false;
  };
  const VertexPlaces places = frames_.places(frame);
  const Point& kept = places[edge.kept];
  const Point& removed = places[edge.removed];
  Point middle = 0.5 * (kept + removed);
  if (single_) {
    for (double& x : middle) x = nearest_float(x);
  }
  // The best, and then the others.
  std::array<Place, 4> all{{{edge_.to[frame], edge_.costs[frame], edge_.flat[frame] != 0},
                            {kept, edge_.costs[frame]},
                            {removed, edge_.costs[frame]},
                            {middle, edge_.costs[frame]}}};
  const std::span<Place> others = std::span(all).subspan(1);
  for (Place& other : others) {
    other.cost = std::max(other.cost, quadrics_->cost_at(edge.kept, edge.removed, frame, other.at));
  }
  std::stable_sort(others.begin(), others.end(),
                   [](const Place& a, const Place& b) { return a.cost < b.cost; });
  const auto take_first = [&](const Legality& rules, std::span<const Place> of, double more) {
    for (const Place& place : of) {
      if (!rules.keeps_faces(star, {edge.kept, edge.removed, place.at}, places)) continue;
      edge_.to[frame] = place.at;
      edge_.costs[frame] = place.cost + more;
      edge_.flat[frame] = place.flat ? 1 : 0;
      return true;
    }
    return false;
  };
  if (take_first(legality, others, 0)) return true;
  if (least_cosine_ <= least_cosine_at_a_cost) return false;
  return take_first(Legality(mesh_, least_cosine_at_a_cost), all,
                    turning_weight * loss_by_turning(mesh_, star, edge, places).surface);
}

double SequenceCost::closer_cost(const EvaluatedCollapse& now, const EdgeStar& star, double cost) {
  const bool costlier = quadrics_->look_closer(now.edge, star, edge_);
  return costlier ? std::max(cost, sum_of_costs(feature_)) : cost;
}

double SequenceCost::cost_of_piece(const TileMesh& mesh, const Piece& piece) {
  for (std::size_t t = 0; t < frames_.count(); ++t)
    edge_.costs[t] =
        WitnessPoints::cost_of(piece_excess * loss_of(mesh, piece, frames_.places(t)).farthest);
  return sum_of_costs(0);
}

double SequenceCost::largest_error() const {
  return std::sqrt(largest_square_);
}

void SequenceCost::collapsing(const EvaluatedCollapse& now, EdgeStar& star) {
  const Collapse& edge = now.edge;
  beside_.begin(edge, star);
  for (std::size_t t = 0; t < frames_.count(); ++t) {
    const double weight = quadrics_->weight(edge.kept, t) + quadrics_->weight(edge.removed, t);
    if (weight > 0) largest_square_ = std::max(largest_square_, edge_.costs[t] / weight);
  }
  quadrics_->collapsing(edge, star, edge_, beside_);
}

void SequenceCost::collapsed(const Collapse& edge) {
  frames_.move(edge.kept, edge_.to);
  quadrics_->collapsed(edge, beside_);
}

void SequenceCost::collapsed(const Collapse& edge, Offers& offers) {
  collapsed(edge);
  beside_.renew(edge, offers, [&] { return best(edge.kept, Candidate::none_yet()); });
}

void SequenceCost::repeat(const Collapse& edge, const Legality& legality, EdgeStar& star) {
  const bool hub = mesh_.hub(edge.kept);
  EvaluatedCollapse now = place(hub ? edge.removed : edge.kept, hub ? edge.kept : edge.removed);
  (void)keeps_faces(legality, star, now);
  (void)closer_cost(now, star, 0);
  collapsing(now, star);
  mesh_.collapse(edge);
  collapsed(edge);
}

}  // namespace winnow
