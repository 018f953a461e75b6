#include "decimate/quadric_cost.hpp"

#include "base/quadric.hpp"

#include <algorithm>

namespace winnow {

namespace {

// Pulls the lowest point towards the middle of the edge where the planes leave it free, as a part of their
// weight: by measurement (bench/RESULTS.md).
constexpr double pull = 1e-4;
// Where planes cost nothing, as on flat parts, short edges go first.
constexpr double length_share = 1e-6;
// Of an upright plane at a border, with the square of the edge's length, beside the areas of faces.
constexpr double border_weight = 1;
// Normals cancel each other where their mean is shorter than 1 by more than this: at needles and fins, not
// along edges and at corners of solids.
constexpr double cancelling = 0.3;

}  // namespace

QuadricCost::QuadricCost(TileMesh& mesh, bool single)
    : mesh_(mesh), planes_(mesh.vertex_count()), at_border_(mesh.vertex_count(), 0), single_(single) {
  find_borders();
  for (FaceNumber f = 0; f < mesh.face_count(); ++f) add_face(f, 1);
}

// Where every neighbour is met in an even number of faces there is no edge with one face: the numbers of a
// vertex's neighbours, each as often as it is met, then cancel out.
void QuadricCost::find_borders() {
  for (VertexNumber v = 0; v < mesh_.vertex_count(); ++v) {
    VertexNumber odd = 0;
    std::uint64_t squares = 0;
    mesh_.for_each_face(v, [&](FaceNumber f) {
      for (const VertexNumber w : mesh_.face(f)) {
        if (w == v) continue;
        odd ^= w;
        squares ^= (std::uint64_t{w} + 1) * (std::uint64_t{w} + 1);
      }
    });
    at_border_[v] = odd != 0 || squares != 0;
  }
}

void QuadricCost::add_face(FaceNumber f, double sign) {
  const Point doubled = doubled_area(mesh_.triangle(f));
  const double square = dot(doubled, doubled);
  if (square > 0) {
    // A third of the area for each corner.
    const double weight = sign / (6 * std::sqrt(square));
    for (const VertexNumber v : mesh_.face(f)) {
      planes_[v].add(doubled, weight);
      planes_[v].normal = planes_[v].normal + (sign / 6) * doubled;
    }
  }
  const FaceVertices& face = mesh_.face(f);
  if (at_border_[face[0]] + at_border_[face[1]] + at_border_[face[2]] >= 2) add_border(f, doubled, sign);
}

// The planes through edges with one face, upright on that.
void QuadricCost::add_border(FaceNumber f, const Point& doubled, double sign) {
  const FaceVertices& face = mesh_.face(f);
  for (std::size_t i = 0; i < 3; ++i) {
    const VertexNumber a = face[i];
    const VertexNumber b = face[(i + 1) % 3];
    if (!at_border_[a] || !at_border_[b] || mesh_.faces_at(a, b) != 1) continue;
    const Point edge = mesh_.position(b) - mesh_.position(a);
    const Point upright = cross(edge, doubled);
    const double square = dot(upright, upright);
    if (!(square > 0)) continue;
    const double weight = sign * border_weight * dot(edge, edge) / square;
    planes_[a].add(upright, weight);
    planes_[b].add(upright, weight);
  }
}

double QuadricCost::wear(VertexNumber v) const {
  const Planes& planes = planes_[v];
  const double weight = planes.weight();
  // At a border the weight is not that of faces alone, and the planes there do notice.
  if (!(weight > 0) || at_border_[v]) return 0;
  const double beyond = (1 - length(planes.normal) / weight - cancelling) / (1 - cancelling);
  return beyond > 0 ? weight * beyond * beyond : 0;
}

PricedCollapse QuadricCost::priced(VertexNumber low, VertexNumber high) const {
  const Point edge = mesh_.position(high) - mesh_.position(low);
  const Planes& p = planes_[low];
  const Planes& q = planes_[high];
  // Seen from `low`: its own planes go through there, those of `high` through the end of the edge.
  Quadric sum{q.xx, q.xy, q.xz, q.yy, q.yz, q.zz, {}, 0};
  sum.b = sum.times(edge);
  sum.c = dot(edge, sum.b);
  sum.xx += p.xx;
  sum.xy += p.xy;
  sum.xz += p.xz;
  sum.yy += p.yy;
  sum.yz += p.yz;
  sum.zz += p.zz;
  const double weight = sum.weight();
  const Point middle = 0.5 * edge;
  const Point t = weight > 0 ? lowest_point(sum, pull * weight, middle) : middle;
  Point position = mesh_.position(low) + t;
  if (single_) {
    for (double& x : position) x = static_cast<double>(static_cast<float>(x));
  }
  if (!finite(position)) position = mesh_.position(low);
  const Point from_low = position - mesh_.position(low);
  const Point from_high = from_low - edge;
  const double error = std::max(0.0, sum.at(from_low));
  const double worn = wear(low) * dot(from_low, from_low) + wear(high) * dot(from_high, from_high);
  return {{low, high, position}, error + worn + length_share * weight * dot(edge, edge)};
}

Candidate QuadricCost::best(VertexNumber v, const Candidate& after) {
  Candidate cheapest;
  if (mesh_.locked(v)) return cheapest;
  // Every edge belongs to its lower end.
  mesh_.for_each_neighbour(v, [&](VertexNumber w) {
    if (w < v || mesh_.locked(w)) return;
    const Candidate candidate{priced(v, w).price, w};
    if (after.before(candidate) && candidate.before(cheapest)) cheapest = candidate;
  });
  return cheapest;
}

PricedCollapse QuadricCost::place(VertexNumber v, VertexNumber partner) const {
  return priced(v, partner);
}

void QuadricCost::collapsing(const Collapse& edge) {
  const PricedCollapse now = priced(edge.kept, edge.removed);
  const double weight = planes_[edge.kept].weight() + planes_[edge.removed].weight();
  if (weight > 0) largest_square_ = std::max(largest_square_, now.price / weight);
  mesh_.for_each_face(edge.kept, [&](FaceNumber f) { add_face(f, -1); });
  mesh_.for_each_face(edge.removed, [&](FaceNumber f) {
    if (!has(mesh_.face(f), edge.kept)) add_face(f, -1);
  });
}

void QuadricCost::collapsed(const Collapse& edge, Offers& offers) {
  const VertexNumber kept = edge.kept;
  at_border_[kept] |= at_border_[edge.removed];
  planes_[kept] = {};  // nothing but rounding was left
  mesh_.for_each_face(kept, [&](FaceNumber f) { add_face(f, 1); });
  offers.set(kept, best(kept, Candidate::none_yet()));
  mesh_.for_each_neighbour(kept, [&](VertexNumber w) { offers.make_stale(w); });
}

}  // namespace winnow
