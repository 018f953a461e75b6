#include "decimate/quadric_cost.hpp"

#include "base/instruction_set.hpp"
#include "base/rounding.hpp"
#include "decimate/quadric_placement.hpp"

#include <algorithm>
#include <limits>
#include <utility>

namespace winnow {

namespace {

// What is left when a piece is gone is farther from it than its middle: eight times as far, by
// measurement. With 1 the error of a scan full of dust is twice as large at the same count, with
// 4096 no smaller (bench/RESULTS.md).
constexpr double piece_weight = 64;
// What is left may be much farther from a piece than it is wide. So it costs at least what a point
// does that is off by so many times the distance of its farthest vertex from its middle: else the
// largest error doubles (bench/RESULTS.md).
constexpr double piece_reach = 6;

}  // namespace

QuadricCost::QuadricCost(TileMesh& mesh, bool single, const CoordinateRounding& rounding)
    : QuadricCost(mesh, single, rounding, WitnessPoints(mesh, rounding.relative), 0) {}

QuadricCost::QuadricCost(TileMesh& mesh, bool single, const CoordinateRounding& rounding,
                         WitnessPoints witnesses, double largest_square)
    : mesh_(mesh),
      single_(single),
      rounding_(rounding),
      planes_(mesh.vertex_count()),
      farthest_(std::move(witnesses)),
      at_boundary_(mesh.vertex_count(), 0),
      evaluate_edges_(best_kernel(WINNOW_KERNELS(edge_kernel))),
      largest_square_(largest_square),
      beside_(mesh) {
  for (VertexNumber v = 0; v < mesh.vertex_count(); ++v) at_boundary_[v] = !mesh.all_edges_even(v);
  for (FaceNumber f = 0; f < mesh.face_count(); ++f) {
    if (mesh.removed(f)) continue;
    const VertexPlanes planes = planes_of(f);
    for (const VertexNumber v : mesh.face(f)) add(planes_[v], planes);
  }
  for (VertexNumber v = 0; v < mesh.vertex_count(); ++v) {
    if (!at_boundary_[v]) continue;
    for (const VertexNumber w : mesh.open_neighbours(v))
      add_line(planes_[v], mesh.position(w) - mesh.position(v), boundary_line_weight);
  }
}

QuadricCost::QuadricCost(TileMesh& mesh, bool single, const CoordinateRounding& rounding,
                         double error, std::vector<ErrorBound::State> states)
    : QuadricCost(mesh, single, rounding) {
  bound_.emplace(mesh, error, std::move(states), at_boundary_);
}

QuadricCost::QuadricCost(TileMesh& mesh, bool single, const CoordinateRounding& rounding,
                         double error, const std::vector<State>& states)
    : QuadricCost(mesh, single, rounding, error,
                  std::vector<ErrorBound::State>(states.begin(), states.end())) {
  for (VertexNumber v = 0; v < mesh.vertex_count(); ++v) farthest_.set(v, states[v].farthest);
}

// Of one face, for each of its corners: a third of the area.
VertexPlanes QuadricCost::planes_of(FaceNumber f) const {
  const Triangle triangle = mesh_.triangle(f);
  const Point doubled = doubled_area(triangle);
  VertexPlanes planes;
  if (thinner_than_rounding(triangle, doubled, rounding_)) return planes;
  add(planes, doubled, 1 / (6 * length(doubled)));
  return planes;
}

// The line of an edge with one face. It needs no face to stand upright on, which may be none but a
// line.
void QuadricCost::add_boundary(VertexNumber a, VertexNumber b, double sign) {
  if (!at_boundary_[a] || !at_boundary_[b]) return;
  const Point edge = mesh_.position(b) - mesh_.position(a);
  add_line(planes_[a], edge, sign * boundary_line_weight);
  add_line(planes_[b], edge, sign * boundary_line_weight);
}

EvaluatedCollapse QuadricCost::place(VertexNumber low, VertexNumber high) {
  set_low(batch_, mesh_.position(low), planes_[low]);
  set_high(batch_, 0, mesh_.position(high), planes_[high], mesh_.hub(high));
  evaluate_edges_(batch_, 1, single_);
  if (mesh_.hub(high)) return {{high, low, mesh_.position(high)}, batch_.cost[0]};
  return {{low, high, position_of(batch_, 0)}, batch_.cost[0]};
}

std::optional<EvaluatedCollapse> QuadricCost::other_place(const EvaluatedCollapse& now) const {
  if (batch_.flat_low[0] == 0 || batch_.flat_high[0] == 0) return std::nullopt;
  const Point& high = mesh_.position(now.edge.removed);
  const bool at_high = now.edge.position == high;
  return EvaluatedCollapse{
      {now.edge.kept, now.edge.removed, at_high ? mesh_.position(now.edge.kept) : high}, now.cost};
}

Candidate QuadricCost::best(VertexNumber v, const Candidate& after) {
  Candidate cheapest;
  if (mesh_.locked(v)) return cheapest;
  set_low(batch_, mesh_.position(v), planes_[v]);
  const std::span<const VertexNumber> ends = mesh_.owned_edges(v);
  for (std::size_t first = 0; first < ends.size(); first += EdgeBatch::capacity) {
    const std::size_t count = std::min(EdgeBatch::capacity, ends.size() - first);
    for (std::size_t i = 0; i < count; ++i) {
      const VertexNumber high = ends[first + i];
      set_high(batch_, i, mesh_.position(high), planes_[high], mesh_.hub(high));
    }
    evaluate_edges_(batch_, count, single_);
    for (std::size_t i = 0; i < count; ++i) {
      const Candidate candidate{batch_.cost[i], ends[first + i]};
      if (after.before(candidate) && candidate.before(cheapest)) cheapest = candidate;
    }
  }
  return cheapest;
}

double QuadricCost::closer_cost(const EvaluatedCollapse& now, const EdgeStar& star, double cost,
                                const SurfaceChange* change) {
  // As place() has found it.
  const bool flat = batch_.flat_low[0] + batch_.flat_high[0] != 0;
  if (!bound_) return farthest_.cost(now.edge, star, cost, flat);
  // Measured whole, so that a repeated collapse, whose cost is not known, remembers the same.
  const double closer = std::max(cost, farthest_.cost(now.edge, star, 0, flat));
  const double far = bound_->farthest();
  const bool near = farthest_.square() <= far * far;
  return near && bound_->allows(now.edge, star, change) ? closer
                                                        : std::numeric_limits<double>::infinity();
}

QuadricCost::State QuadricCost::state(VertexNumber v) const {
  return {bound_->state(v), farthest_.of(v)};
}

double QuadricCost::largest_error() const {
  return bound_ ? bound_->largest_error() : std::sqrt(largest_square_);
}

double QuadricCost::cost_of(const PieceLoss& loss) {
  return std::max(piece_weight * (loss.surface + boundary_line_weight * loss.boundary),
                  WitnessPoints::cost_of(piece_reach * piece_reach * loss.farthest));
}

double QuadricCost::cost_of_piece(const TileMesh& mesh, const Piece& piece) const {
  if (bound_ && !bound_->allows(piece)) return std::numeric_limits<double>::infinity();
  return cost_of(loss_of(mesh, piece));
}

double QuadricCost::cost_of_change(const EdgeStar& star, const Collapse& edge,
                                   const SurfaceChange& change) {
  if (bound_ && !bound_->allows(star, change)) return std::numeric_limits<double>::infinity();
  const PieceLoss loss = loss_of(mesh_, star, edge, change);
  return loss.surface + boundary_line_weight * loss.boundary;
}

double QuadricCost::cost_of_turning(const EdgeStar& star, const Collapse& edge) const {
  if (bound_) return std::numeric_limits<double>::infinity();
  return loss_by_turning(mesh_, star, edge).surface;
}

void QuadricCost::take_anew(VertexNumber v) {
  planes_[v] = {};
  mesh_.for_each_face(v, [&](FaceNumber f) { add(planes_[v], planes_of(f)); });
  if (!mesh_.all_edges_even(v)) {
    at_boundary_[v] = 1;
    for (const VertexNumber w : mesh_.open_neighbours(v))
      add_line(planes_[v], mesh_.position(w) - mesh_.position(v), boundary_line_weight);
  }
}

void QuadricCost::faces_gone(std::span<const FaceVertices> faces, Offers& offers) {
  faces_gone(faces);
  for (const FaceVertices& face : faces) {
    for (const VertexNumber v : face) offers.make_stale(v);
  }
}

void QuadricCost::collapsing(const EvaluatedCollapse& now, const EdgeStar& star) {
  const VertexNumber kept = now.edge.kept;
  const VertexNumber removed = now.edge.removed;
  farthest_.collapsing(now.edge);
  if (bound_) bound_->collapsing(now.edge);
  const double weight = weight_of(planes_[kept]) + weight_of(planes_[removed]);
  if (weight > 0) largest_square_ = std::max(largest_square_, now.cost / weight);
  beside_.begin(now.edge, star);
  const auto faces = star.faces();
  at_boundary_now_ = (at_boundary_[kept] | at_boundary_[removed]) != 0;
  if (at_boundary_now_) {
    beside_.for_each_open_before(
        now.edge, star, [&](VertexNumber end, VertexNumber w) { add_boundary(end, w, -1); });
  }
  planes_of_kept_ = beside_.into_hub() ? planes_[kept] : VertexPlanes{};
  for (std::size_t i = 0; i < faces.size(); ++i) {
    const VertexPlanes change = star.change(i);
    add(planes_[faces[i].w], change);
    add(planes_[faces[i].x], change);
    // A hub's own faces stay as they are, but for those at the edge.
    add(planes_of_kept_, beside_.into_hub() && !faces[i].stays ? change : star.planes(i));
  }
}

void QuadricCost::collapsed(const Collapse& edge) {
  const VertexNumber kept = edge.kept;
  planes_[kept] = planes_of_kept_;
  at_boundary_[kept] |= at_boundary_[edge.removed];
  if (!at_boundary_now_) return;
  beside_.for_each_open_after(edge,
                              [&](VertexNumber end, VertexNumber w) { add_boundary(end, w, 1); });
}

void QuadricCost::collapsed(const Collapse& edge, Offers& offers) {
  collapsed(edge);
  beside_.renew(edge, offers, [&] { return best(edge.kept, Candidate::none_yet()); });
}

void QuadricCost::repeat(const Collapse& edge, EdgeStar& star, const SurfaceChange* change) {
  star.move(mesh_, edge.position, -1);
  const bool hub = mesh_.hub(edge.kept);
  (void)place(hub ? edge.removed : edge.kept, hub ? edge.kept : edge.removed);
  (void)closer_cost({edge, 0}, star, 0, change);
  collapsing({edge, 0}, star);
  mesh_.collapse(edge);
  collapsed(edge);
}

void QuadricCost::faces_gone(std::span<const FaceVertices> faces) {
  for (const FaceVertices& face : faces) {
    for (const VertexNumber v : face) {
      if (!mesh_.hub(v)) take_anew(v);
    }
  }
}

}  // namespace winnow
