#include "decimate/error_bound.hpp"

#include "base/cell_state.hpp"
#include "base/closest_point.hpp"
#include "base/rounding.hpp"
#include "decimate/quadric_placement.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace winnow {

namespace {

// How far a boundary may move, beside the error.
constexpr double boundary_share = 1.5;
constexpr double unbounded = std::numeric_limits<double>::infinity();

double distance(const Point& p, std::span<const std::array<Point, 2>> segments) {
  double square = unbounded;
  for (const auto& [a, b] : segments) {
    const Point off = closest_point(p, {a, b, b}) - p;
    square = std::min(square, dot(off, off));
  }
  return std::sqrt(square);
}

}  // namespace

void ErrorBound::add_faces(const TileMesh& mesh, const CoordinateRounding& rounding,
                           std::vector<State>& states) {
  for (FaceNumber f = 0; f < mesh.face_count(); ++f) {
    const Triangle triangle = mesh.triangle(f);
    const Point doubled = doubled_area(triangle);
    if (thinner_than_rounding(triangle, doubled, rounding)) continue;
    const double size = length(doubled);
    // The plane goes through each of its corners.
    for (const VertexNumber v : mesh.face(f))
      states[v].planes.add_plane((1 / size) * doubled, {}, size / 6);
  }
}

void ErrorBound::add_boundaries(TileMesh& mesh, std::vector<State>& states) {
  for (VertexNumber v = 0; v < mesh.vertex_count(); ++v) {
    if (mesh.all_edges_even(v)) continue;
    for (const VertexNumber w : mesh.open_neighbours(v))
      states[v].planes.add_line(mesh.position(w) - mesh.position(v), boundary_line_weight);
  }
}

void ErrorBound::add_box(VertexNumber v, Box& box) const {
  const Point& at = mesh_.position(v);
  const State& state = state_[v];
  for (std::size_t axis = 0; axis < 3; ++axis) {
    box.low[axis] = std::min(box.low[axis], at[axis] + static_cast<double>(state.low[axis]));
    box.high[axis] = std::max(box.high[axis], at[axis] + static_cast<double>(state.high[axis]));
  }
}

bool ErrorBound::allows(const Piece& piece) const {
  return size_of(piece.vertices) < error_;
}

bool ErrorBound::allows(const EdgeStar& star, const SurfaceChange& change) const {
  return size_of(star, change) < error_;
}

double ErrorBound::size_of(const EdgeStar& star, const SurfaceChange& change) const {
  if (change.pinches_boundary) return unbounded;
  double size = 0;
  for (const VertexNumber v : change.across)
    size = std::max(size, size_of(std::array{star.kept(), star.removed(), v}));
  for (const FaceVertices& face : change.pairs)
    size = std::max(size, size_of(std::array{star.kept(), face[0], face[1], face[2]}));
  return size;
}

double ErrorBound::size_of(std::span<const VertexNumber> vertices) const {
  Box box{mesh_.position(vertices.front()), mesh_.position(vertices.front())};
  for (const VertexNumber v : vertices) add_box(v, box);
  return box.longest_side();
}

double ErrorBound::above(double size) {
  return std::nextafter(size, unbounded);
}

double ErrorBound::needed(const EdgeStar& star, const SurfaceChange& change) const {
  return above(size_of(star, change));
}

double ErrorBound::needed() const {
  // Its square is compared.
  constexpr double rounding = 1e-15;
  const double planes =
      planes_.c > 0 ? (1 + rounding) * std::sqrt(planes_.c / planes_.weight()) : 0;
  return std::max(planes, boundary_off_ / boundary_share);
}

bool ErrorBound::allows(const Collapse& edge, const EdgeStar& star, const SurfaceChange* change) {
  planes_ = state_[edge.kept].planes.from(edge.position - mesh_.position(edge.kept));
  planes_.add(state_[edge.removed].planes.from(edge.position - mesh_.position(edge.removed)));
  planes_.c = std::max(0.0, planes_.c);
  boundary_starts_.clear();
  boundary_off_ = 0;
  if (planes_.c > error_ * error_ * planes_.weight()) return false;
  if (!(at_boundary_[edge.kept] | at_boundary_[edge.removed])) return true;
  boundary_off_ = boundary_moved(edge, star, change);
  return boundary_off_ <= boundary_share * error_;
}

// Compares the boundary's edges at the two ends with those at the one that is left. A piece whose
// boundary goes altogether moves it by more than any bound. One that closes is let go.
double ErrorBound::boundary_moved(const Collapse& edge, const EdgeStar& star,
                                  const SurfaceChange* change) {
  const VertexNumber kept = edge.kept;
  const VertexNumber removed = edge.removed;
  const Point& to = edge.position;
  const auto is_end = [&](VertexNumber v) { return v == kept || v == removed; };
  before_.clear();
  after_.clear();
  double off = 0;
  const auto leave = [&](VertexNumber a, VertexNumber b) {
    const VertexNumber start = is_end(a) ? kept : a;
    after_.push_back({is_end(a) ? to : mesh_.position(a), is_end(b) ? to : mesh_.position(b)});
    boundary_starts_.push_back(start);
  };
  for (const StarFace& face : star.faces()) {
    const FaceVertices& corner = mesh_.face(face.number);
    for (std::size_t i = 0; i < 3; ++i) {
      const VertexNumber a = corner[i];
      const VertexNumber b = corner[(i + 1) % 3];
      if (!is_end(a) && !is_end(b)) continue;
      const bool open = at_boundary_[a] && at_boundary_[b] && mesh_.faces_at(a, b, 2) == 1;
      const auto closes = [&](VertexNumber v) {
        if (is_end(v)) return true;
        return change != nullptr &&
               std::find(change->across.begin(), change->across.end(), v) != change->across.end();
      };
      if (open && change != nullptr && !change->across.empty() && closes(a) && closes(b)) continue;
      if (open) {
        before_.push_back({mesh_.position(a), mesh_.position(b)});
        off = std::max(off, state_[a].boundary_off);
      }
      if (is_end(a) && is_end(b)) continue;
      if (face.stays) {
        if (open) leave(a, b);
        continue;
      }
      // Of a face at the edge one of the other two sides becomes what is left of both.
      const VertexNumber across = is_end(a) ? b : a;
      const VertexNumber end = is_end(a) ? a : b;
      if (end != removed) continue;
      const unsigned others =
          mesh_.faces_at(kept, across, 3) + mesh_.faces_at(removed, across, 3) - 2;
      if (others == 1) leave(a, b);
    }
  }
  if (before_.empty()) return 0;
  if (after_.empty()) return unbounded;
  double moved = distance(to, before_);
  for (const auto& [a, b] : before_) {
    for (const Point& p : {a, b, 0.5 * (a + b)}) moved = std::max(moved, distance(p, after_));
  }
  return off + moved;
}

void ErrorBound::collapsing(const Collapse& edge) {
  State& kept = state_[edge.kept];
  kept.planes = planes_;
  Box box{edge.position, edge.position};
  add_box(edge.kept, box);
  add_box(edge.removed, box);
  for (std::size_t axis = 0; axis < 3; ++axis) {
    kept.low[axis] = outwards(box.low[axis] - edge.position[axis], -1);
    kept.high[axis] = outwards(box.high[axis] - edge.position[axis], 1);
  }
  if (planes_.weight() > 0)
    largest_square_ = std::max(largest_square_, planes_.c / planes_.weight());
  for (const VertexNumber v : boundary_starts_)
    state_[v].boundary_off = std::max(state_[v].boundary_off, boundary_off_);
}

double ErrorBound::largest_error() const {
  return std::sqrt(largest_square_);
}

}  // namespace winnow
