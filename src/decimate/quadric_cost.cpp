#include "decimate/quadric_cost.hpp"

#include "base/instruction_set.hpp"
#include "decimate/quadric_placement.hpp"

#include <algorithm>

namespace winnow {

namespace {

void add(VertexPlanes& planes, const Point& along, double weight) {
  planes.xx += weight * along[0] * along[0];
  planes.xy += weight * along[0] * along[1];
  planes.xz += weight * along[0] * along[2];
  planes.yy += weight * along[1] * along[1];
  planes.yz += weight * along[1] * along[2];
  planes.zz += weight * along[2] * along[2];
}

void add(VertexPlanes& planes, const VertexPlanes& more) {
  planes.xx += more.xx;
  planes.xy += more.xy;
  planes.xz += more.xz;
  planes.yy += more.yy;
  planes.yz += more.yz;
  planes.zz += more.zz;
  for (std::size_t axis = 0; axis < 3; ++axis) planes.normal[axis] += more.normal[axis];
}

double weight_of(const VertexPlanes& planes) {
  return planes.xx + planes.yy + planes.zz;
}

}  // namespace

QuadricCost::QuadricCost(TileMesh& mesh, bool single)
    : mesh_(mesh),
      planes_(mesh.vertex_count()),
      at_border_(mesh.vertex_count(), 0),
      price_edges_(best_kernel(edge_kernel_baseline, edge_kernel_avx2, edge_kernel_avx512)),
      single_(single) {
  for (VertexNumber v = 0; v < mesh.vertex_count(); ++v) at_border_[v] = !mesh.all_edges_even(v);
  for (FaceNumber f = 0; f < mesh.face_count(); ++f) {
    const VertexPlanes planes = planes_of(f, 1);
    for (const VertexNumber v : mesh.face(f)) add(planes_[v], planes);
    if (touches_border(f)) add_border(f, 1);
  }
}

// Of one face, for each of its corners: a third of the area.
VertexPlanes QuadricCost::planes_of(FaceNumber f, double sign) const {
  const Point doubled = doubled_area(mesh_.triangle(f));
  const double square = dot(doubled, doubled);
  VertexPlanes planes;
  if (!(square > 0)) return planes;
  add(planes, doubled, sign / (6 * std::sqrt(square)));
  for (std::size_t axis = 0; axis < 3; ++axis) planes.normal[axis] = sign / 6 * doubled[axis];
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

void QuadricCost::begin_edges(VertexNumber low) {
  const Point& from = mesh_.position(low);
  std::copy(from.begin(), from.end(), batch_.low);
  batch_.low_planes = planes_[low];
  batch_.low_wears = wears(low);
}

void QuadricCost::set_edge(std::size_t i, VertexNumber high) {
  const Point& to = mesh_.position(high);
  const VertexPlanes& planes = planes_[high];
  for (std::size_t axis = 0; axis < 3; ++axis) {
    batch_.high[axis][i] = to[axis];
    batch_.normal[axis][i] = planes.normal[axis];
  }
  batch_.xx[i] = planes.xx;
  batch_.xy[i] = planes.xy;
  batch_.xz[i] = planes.xz;
  batch_.yy[i] = planes.yy;
  batch_.yz[i] = planes.yz;
  batch_.zz[i] = planes.zz;
  batch_.wears[i] = wears(high);
}

PricedCollapse QuadricCost::place(VertexNumber low, VertexNumber high) {
  begin_edges(low);
  set_edge(0, high);
  price_edges_(batch_, 1, single_);
  const Point position{batch_.position[0][0], batch_.position[1][0], batch_.position[2][0]};
  return {{low, high, position}, batch_.price[0]};
}

Candidate QuadricCost::best(VertexNumber v, const Candidate& after) {
  Candidate cheapest;
  if (mesh_.locked(v)) return cheapest;
  begin_edges(v);
  const std::span<const VertexNumber> ends = owned_edges(mesh_, v, ends_);
  for (std::size_t first = 0; first < ends.size(); first += EdgeBatch::capacity) {
    const std::size_t count = std::min(EdgeBatch::capacity, ends.size() - first);
    for (std::size_t i = 0; i < count; ++i) set_edge(i, ends[first + i]);
    price_edges_(batch_, count, single_);
    for (std::size_t i = 0; i < count; ++i) {
      const Candidate candidate{batch_.price[i], ends[first + i]};
      if (after.before(candidate) && candidate.before(cheapest)) cheapest = candidate;
    }
  }
  return cheapest;
}

void QuadricCost::collapsing(const PricedCollapse& now) {
  const VertexNumber kept = now.edge.kept;
  const VertexNumber removed = now.edge.removed;
  const double weight = weight_of(planes_[kept]) + weight_of(planes_[removed]);
  if (weight > 0) largest_square_ = std::max(largest_square_, now.price / weight);
  // Of the faces that go or move, the planes at the vertices around.
  const auto take_away = [&](FaceNumber f, VertexNumber w, VertexNumber x) {
    const VertexPlanes planes = planes_of(f, -1);
    add(planes_[w], planes);
    add(planes_[x], planes);
    if (touches_border(f)) add_border(f, -1);
  };
  mesh_.for_each_corner(kept, take_away);
  mesh_.for_each_corner(removed, [&](FaceNumber f, VertexNumber w, VertexNumber x) {
    if (w != kept && x != kept) take_away(f, w, x);
  });
}

void QuadricCost::collapsed(const Collapse& edge, Offers& offers) {
  const VertexNumber kept = edge.kept;
  at_border_[kept] |= at_border_[edge.removed];
  planes_[kept] = {};
  mesh_.for_each_corner(kept, [&](FaceNumber f, VertexNumber w, VertexNumber x) {
    const VertexPlanes planes = planes_of(f, 1);
    for (const VertexNumber v : {kept, w, x}) add(planes_[v], planes);
    if (touches_border(f)) add_border(f, 1);
  });
  offers.set(kept, best(kept, Candidate::none_yet()));
  for (const VertexNumber w : mesh_.neighbours(kept)) offers.make_stale(w);
}

}  // namespace winnow
