#include "decimate/sequence_cost.hpp"

#include "base/instruction_set.hpp"
#include "base/rounding.hpp"
#include "decimate/edge_feature.hpp"
#include "decimate/quadric_cost.hpp"
#include "decimate/quadric_placement.hpp"
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
// No collapse turns a face by more than 90 degrees.
constexpr double least_cosine_at_a_cost = 0;

double error_at(const VertexPlanes& p, const Point& t) {
  return t[0] * (p.xx * t[0] + p.xy * t[1] + p.xz * t[2]) +
         t[1] * (p.xy * t[0] + p.yy * t[1] + p.yz * t[2]) +
         t[2] * (p.xz * t[0] + p.yz * t[1] + p.zz * t[2]);
}

VertexPlanes planes_of(const Triangle& triangle, const CoordinateRounding& rounding) {
  const Point doubled = doubled_area(triangle);
  VertexPlanes planes;
  if (!thinner_than_rounding(triangle, doubled, rounding))
    add(planes, doubled, 1 / (6 * length(doubled)));
  return planes;
}

}  // namespace

SequenceCost::SequenceCost(TileMesh& mesh, Frames& frames, const DecimationSettings& settings)
    : mesh_(mesh),
      frames_(frames),
      settings_(*settings.sequence),
      single_(settings.single),
      rounding_(settings.rounding_of_positions()),
      least_cosine_(settings.least_cosine),
      planes_(frames.count() * mesh.vertex_count()),
      at_boundary_(mesh.vertex_count(), 0),
      evaluate_edges_(best_kernel(WINNOW_KERNELS(edge_kernel))),
      costs_(frames.count()),
      to_(frames.count()),
      flat_(frames.count()),
      witness_(frames.count()),
      planes_of_kept_(frames.count()),
      beside_(mesh) {
  for (VertexNumber v = 0; v < mesh.vertex_count(); ++v) at_boundary_[v] = !mesh.all_edges_even(v);
  for (FaceNumber f = 0; f < mesh.face_count(); ++f) {
    if (mesh.removed(f)) continue;
    for (std::size_t t = 0; t < frames.count(); ++t) {
      const VertexPlanes of_face = planes_of(frames.places(t).triangle(mesh.face(f)), rounding_);
      for (const VertexNumber v : mesh.face(f)) add(planes(v, t), of_face);
    }
  }
  for (VertexNumber v = 0; v < mesh.vertex_count(); ++v) {
    if (!at_boundary_[v]) continue;
    for (const VertexNumber w : mesh.open_neighbours(v)) {
      for (std::size_t t = 0; t < frames.count(); ++t)
        add_line(planes(v, t), frames.positions(w)[t] - frames.positions(v)[t],
                 boundary_line_weight);
    }
  }
}

// A batch has one edge in several frames.
void SequenceCost::evaluate(VertexNumber low, VertexNumber high) {
  const std::span<const Point> of_low = frames_.positions(low);
  const std::span<const Point> of_high = frames_.positions(high);
  const bool stays = mesh_.hub(high);
  for (std::size_t first = 0; first < costs_.size(); first += EdgeBatch::capacity) {
    const std::size_t count = std::min(EdgeBatch::capacity, costs_.size() - first);
    for (std::size_t i = 0; i < count; ++i) {
      set_low(batch_, i, of_low[first + i], planes(low, first + i));
      set_high(batch_, i, of_high[first + i], planes(high, first + i), stays);
    }
    evaluate_edges_(batch_, count, single_);
    for (std::size_t i = 0; i < count; ++i) {
      costs_[first + i] = batch_.cost[i];
      to_[first + i] = position_of(batch_, i);
      flat_[first + i] = batch_.flat_low[i] + batch_.flat_high[i] != 0;
    }
  }
}

double SequenceCost::feature_weight(VertexNumber low, VertexNumber high) {
  if (settings_.feature_weight == 0 || mesh_.hub(low) || mesh_.hub(high)) return 0;
  const double first = feature_of(mesh_, frames_.places(0), low, high).weight;
  const double last = feature_of(mesh_, frames_.places(frames_.count() - 1), low, high).weight;
  return (first + last) / 2;
}

double SequenceCost::sum_of_costs(double feature) const {
  const double sum = std::accumulate(costs_.begin(), costs_.end(), 0.0);
  double all = (1 + settings_.feature_weight * feature) * sum;
  if (settings_.deformation_weight == 0) return all;
  const double mean = sum / static_cast<double>(costs_.size());
  double deformation = 0;
  for (const double cost : costs_) deformation += std::abs(cost - mean);
  return all + settings_.deformation_weight * deformation;
}

Candidate SequenceCost::best(VertexNumber v, const Candidate& after) {
  Candidate cheapest;
  if (mesh_.locked(v)) return cheapest;
  const std::span<const VertexNumber> ends = mesh_.owned_edges(v);
  ends_.assign(ends.begin(), ends.end());
  for (const VertexNumber end : ends_) {
    evaluate(v, end);
    const Candidate candidate{sum_of_costs(feature_weight(v, end)), end};
    if (after.before(candidate) && candidate.before(cheapest)) cheapest = candidate;
  }
  return cheapest;
}

EvaluatedCollapse SequenceCost::place(VertexNumber low, VertexNumber high) {
  evaluate(low, high);
  feature_ = feature_weight(low, high);
  const double cost = sum_of_costs(feature_);
  if (!mesh_.hub(high)) return {{low, high, to_.front()}, cost};
  const std::span<const Point> stays = frames_.positions(high);
  to_.assign(stays.begin(), stays.end());
  return {{high, low, to_.front()}, cost};
}

bool SequenceCost::keeps_faces(const Legality& legality, EdgeStar& star, EvaluatedCollapse& now) {
  bool otherwise = false;
  for (std::size_t t = 0; t < frames_.count(); ++t) {
    const Collapse edge{now.edge.kept, now.edge.removed, to_[t]};
    if (legality.keeps_faces(star, edge, frames_.places(t))) continue;
    if (!place_otherwise(t, legality, star, edge)) return false;
    otherwise = true;
  }
  now.edge.position = to_.front();
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
  std::array<Place, 4> all{{{to_[frame], costs_[frame], flat_[frame] != 0},
                            {kept, costs_[frame]},
                            {removed, costs_[frame]},
                            {middle, costs_[frame]}}};
  const std::span<Place> others = std::span(all).subspan(1);
  for (Place& other : others) {
    other.cost =
        std::max(other.cost, error_at(planes(edge.kept, frame), other.at - kept) +
                                 error_at(planes(edge.removed, frame), other.at - removed));
  }
  std::stable_sort(others.begin(), others.end(),
                   [](const Place& a, const Place& b) { return a.cost < b.cost; });
  const auto take_first = [&](const Legality& rules, std::span<const Place> of, double more) {
    for (const Place& place : of) {
      if (!rules.keeps_faces(star, {edge.kept, edge.removed, place.at}, places)) continue;
      to_[frame] = place.at;
      costs_[frame] = place.cost + more;
      flat_[frame] = place.flat ? 1 : 0;
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
  const VertexNumber kept = now.edge.kept;
  const VertexNumber removed = now.edge.removed;
  const bool hub = mesh_.hub(kept);
  bool costlier = false;
  for (std::size_t t = 0; t < frames_.count(); ++t) {
    const VertexPlaces places = frames_.places(t);
    const Point& to = to_[t];
    const bool flat = flat_[t] != 0;
    const double near = WitnessPoints::near_square(to, costs_[t], rounding_.relative);
    const Point& of_kept = flat ? places[kept] : frames_.witnesses(kept)[t];
    const Point& of_removed = flat ? places[removed] : frames_.witnesses(removed)[t];
    const double kept_square =
        hub ? 0 : square_beside_star(of_kept, to, star.of_kept(), star.of_removed(), places, near);
    const double removed_square =
        square_beside_star(of_removed, to, star.of_removed(), star.of_kept(), places, near);
    const bool first = hub || (flat ? to == places[kept] : kept_square >= removed_square);
    witness_[t] = frames_.witnesses(first ? kept : removed)[t];
    const double square = std::max(kept_square, removed_square);
    if (square <= near) continue;
    costs_[t] = std::max(costs_[t], WitnessPoints::cost_of(square));
    costlier = true;
  }
  return costlier ? std::max(cost, sum_of_costs(feature_)) : cost;
}

double SequenceCost::cost_of_piece(const TileMesh& mesh, const Piece& piece) {
  for (std::size_t t = 0; t < frames_.count(); ++t)
    costs_[t] = QuadricCost::cost_of(loss_of(mesh, piece, frames_.places(t)));
  return sum_of_costs(0);
}

double SequenceCost::largest_error() const {
  return std::sqrt(largest_square_);
}

void SequenceCost::add_boundary(VertexNumber a, VertexNumber b, double sign) {
  if (!at_boundary_[a] || !at_boundary_[b]) return;
  for (std::size_t t = 0; t < frames_.count(); ++t) {
    const Point edge = frames_.positions(b)[t] - frames_.positions(a)[t];
    add_line(planes(a, t), edge, sign * boundary_line_weight);
    add_line(planes(b, t), edge, sign * boundary_line_weight);
  }
}

void SequenceCost::collapsing(const EvaluatedCollapse& now, EdgeStar& star) {
  const VertexNumber kept = now.edge.kept;
  const VertexNumber removed = now.edge.removed;
  beside_.begin(now.edge, star);
  at_boundary_now_ = (at_boundary_[kept] | at_boundary_[removed]) != 0;
  for (std::size_t t = 0; t < frames_.count(); ++t) {
    const double weight = weight_of(planes(kept, t)) + weight_of(planes(removed, t));
    if (weight > 0) largest_square_ = std::max(largest_square_, costs_[t] / weight);
  }
  if (at_boundary_now_) {
    beside_.for_each_open_before(
        now.edge, star, [&](VertexNumber end, VertexNumber w) { add_boundary(end, w, -1); });
  }
  const auto faces = star.faces();
  for (std::size_t t = 0; t < frames_.count(); ++t) {
    star.move(frames_.places(t), to_[t], least_cosine_);
    VertexPlanes& of_kept = planes_of_kept_[t];
    of_kept = beside_.into_hub() ? planes(kept, t) : VertexPlanes{};
    for (std::size_t i = 0; i < faces.size(); ++i) {
      const VertexPlanes change = star.change(i);
      add(planes(faces[i].w, t), change);
      add(planes(faces[i].x, t), change);
      // A hub's own faces stay as they are, but for those at the edge.
      add(of_kept, beside_.into_hub() && !faces[i].stays ? change : star.planes(i));
    }
  }
  frames_.set_witnesses(kept, witness_);
}

void SequenceCost::collapsed(const Collapse& edge) {
  const VertexNumber kept = edge.kept;
  frames_.move(kept, to_);
  for (std::size_t t = 0; t < frames_.count(); ++t) planes(kept, t) = planes_of_kept_[t];
  at_boundary_[kept] |= at_boundary_[edge.removed];
  if (!at_boundary_now_) return;
  beside_.for_each_open_after(edge,
                              [&](VertexNumber end, VertexNumber w) { add_boundary(end, w, 1); });
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
