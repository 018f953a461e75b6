#include "decimate/quadric_cost.hpp"

#include "base/instruction_set.hpp"
#include "decimate/quadric_placement.hpp"

#include <algorithm>

namespace winnow {

QuadricCost::QuadricCost(TileMesh& mesh, bool single)
    : mesh_(mesh),
      planes_(mesh.vertex_count()),
      farthest_(mesh),
      at_border_(mesh.vertex_count(), 0),
      price_edges_(best_kernel(edge_kernel_baseline, edge_kernel_avx2, edge_kernel_avx512)),
      single_(single) {
  for (VertexNumber v = 0; v < mesh.vertex_count(); ++v) at_border_[v] = !mesh.all_edges_even(v);
  for (FaceNumber f = 0; f < mesh.face_count(); ++f) {
    const VertexPlanes planes = planes_of(f);
    for (const VertexNumber v : mesh.face(f)) add(planes_[v], planes);
    if (touches_border(f)) add_border(f, 1);
  }
}

// Of one face, for each of its corners: a third of the area.
VertexPlanes QuadricCost::planes_of(FaceNumber f) const {
  const Point doubled = doubled_area(mesh_.triangle(f));
  const double square = dot(doubled, doubled);
  VertexPlanes planes;
  if (!(square > 0)) return planes;
  add(planes, doubled, 1 / (6 * std::sqrt(square)));
  return planes;
}

// The planes through edges with one face, upright on that.
void QuadricCost::add_border(FaceNumber f, double sign) {
  const FaceVertices& face = mesh_.face(f);
  const Point doubled = doubled_area(mesh_.triangle(f));
  for (std::size_t i = 0; i < 3; ++i) {
    const VertexNumber a = face[i];
    const VertexNumber b = face[(i + 1) % 3];
    if (!at_border_[a] || !at_border_[b] || mesh_.faces_at(a, b) != 1) continue;
    const Point edge = mesh_.position(b) - mesh_.position(a);
    const Point upright = cross(edge, doubled);
    const double square = dot(upright, upright);
    if (!(square > 0)) continue;
    const double weight = sign * upright_plane_weight * dot(edge, edge) / square;
    add(planes_[a], upright, weight);
    add(planes_[b], upright, weight);
  }
}

PricedCollapse QuadricCost::place(VertexNumber low, VertexNumber high) {
  set_low(batch_, mesh_.position(low), planes_[low]);
  set_high(batch_, 0, mesh_.position(high), planes_[high]);
  price_edges_(batch_, 1, single_);
  return {{low, high, position_of(batch_, 0)}, batch_.price[0]};
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
      set_high(batch_, i, mesh_.position(high), planes_[high]);
    }
    price_edges_(batch_, count, single_);
    for (std::size_t i = 0; i < count; ++i) {
      const Candidate candidate{batch_.price[i], ends[first + i]};
      if (after.before(candidate) && candidate.before(cheapest)) cheapest = candidate;
    }
  }
  return cheapest;
}

void QuadricCost::collapsing(const PricedCollapse& now, const EdgeStar& star) {
  const VertexNumber kept = now.edge.kept;
  const VertexNumber removed = now.edge.removed;
  farthest_.collapsing(now.edge);
  const double weight = weight_of(planes_[kept]) + weight_of(planes_[removed]);
  if (weight > 0) largest_square_ = std::max(largest_square_, now.price / weight);
  planes_of_kept_ = {};
  const auto faces = star.faces();
  unsigned border = at_border_[kept] | at_border_[removed];
  for (std::size_t i = 0; i < faces.size(); ++i) {
    const VertexPlanes change = star.change(i);
    add(planes_[faces[i].w], change);
    add(planes_[faces[i].x], change);
    add(planes_of_kept_, star.planes(i));
    border |= static_cast<unsigned>(at_border_[faces[i].w] | at_border_[faces[i].x]);
  }
  near_border_ = border != 0;
  for (std::size_t i = 0; i < faces.size() && near_border_; ++i) {
    if (touches_border(faces[i].number)) add_border(faces[i].number, -1);
  }
}

void QuadricCost::collapsed(const Collapse& edge, Offers& offers) {
  const VertexNumber kept = edge.kept;
  planes_[kept] = planes_of_kept_;
  at_border_[kept] |= at_border_[edge.removed];
  if (near_border_) {
    mesh_.for_each_face(kept, [&](FaceNumber f) {
      if (touches_border(f)) add_border(f, 1);
    });
  }
  offers.set(kept, best(kept, Candidate::none_yet()));
  for (const VertexNumber w : mesh_.neighbours(kept)) offers.make_stale(w);
}

}  // namespace winnow
