#include "decimate/legality.hpp"

#include <algorithm>
#include <cmath>

namespace winnow {

namespace {

// A face this thin, as the sine of an angle, is a line: its normal is made of rounding.
constexpr double thinnest = 1e-6;

}  // namespace

// Whether the number of faces of some edge at `v` is one that is asked for.
template <typename Asked>
bool Legality::some_edge_has(VertexNumber v, const Asked& asked) {
  met_.clear();
  mesh_.for_each_corner(v, [&](FaceNumber, VertexNumber w, VertexNumber x) {
    met_.insert(met_.end(), {w, x});
  });
  std::sort(met_.begin(), met_.end());
  for (auto first = met_.begin(); first != met_.end();) {
    const auto end = std::find_if(first, met_.end(), [first](VertexNumber w) { return w != *first; });
    if (asked(end - first)) return true;
    first = end;
  }
  return false;
}

bool Legality::at_border(VertexNumber v) {
  return some_edge_has(v, [](std::ptrdiff_t faces) { return faces != 2; });
}

bool Legality::keeps_surface(VertexNumber a, VertexNumber b) {
  const TileMesh::Meeting meeting = mesh_.meeting(a, b);
  if (meeting.faces == 0 || meeting.common != meeting.faces || meeting.falls_together) return false;
  if (meeting.faces != 2 || mesh_.all_edges_even(b)) return true;
  const auto open = [](std::ptrdiff_t faces) { return faces == 1; };
  return !some_edge_has(b, open) || !some_edge_has(a, open);
}

bool Legality::turned_too_far(const Triangle& before, const Point& to) const {
  const Triangle after{to, before[1], before[2]};
  const Point old_normal = doubled_area(before);
  const Point new_normal = doubled_area(after);
  const double new_square = dot(new_normal, new_normal);
  const Point u = after[1] - after[0];
  const Point v = after[2] - after[0];
  const Point w = after[2] - after[1];
  const double longest = std::max({dot(u, u), dot(v, v), dot(w, w)});
  if (!(new_square > thinnest * thinnest * longest * longest)) return true;
  const double old_square = dot(old_normal, old_normal);
  if (old_square == 0) return false;  // it had no direction to turn from
  return !(dot(old_normal, new_normal) >= least_cosine_ * std::sqrt(old_square * new_square));
}

bool Legality::keeps_faces(const Collapse& edge) const {
  bool good = true;
  const auto check = [&](VertexNumber moving, VertexNumber other) {
    const Point from = mesh_.position(moving);
    mesh_.for_each_corner(moving, [&](FaceNumber, VertexNumber w, VertexNumber x) {
      if (!good || w == other || x == other) return;
      good = !turned_too_far({from, mesh_.position(w), mesh_.position(x)}, edge.position);
    });
  };
  check(edge.removed, edge.kept);
  if (good && edge.position != mesh_.position(edge.kept)) check(edge.kept, edge.removed);
  return good;
}

}  // namespace winnow
