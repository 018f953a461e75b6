#include "decimate/legality.hpp"

#include <algorithm>
#include <cmath>

namespace winnow {

namespace {

// A face this thin, as the sine of an angle, is a line: its normal is made of rounding.
constexpr double thinnest = 1e-6;

}  // namespace

Legality::Legality(const TileMesh& mesh, double least_cosine)
    : mesh_(mesh), least_cosine_(least_cosine), place_(mesh.vertex_count(), no_number) {}

void Legality::list_neighbours(VertexNumber v, std::vector<Neighbour>& list) {
  list.clear();
  mesh_.for_each_face(v, [&](FaceNumber f) {
    for (const VertexNumber w : mesh_.face(f)) {
      if (w == v) continue;
      if (stands_in(w, list)) {
        ++list[place_[w]].faces;
      } else {
        place_[w] = static_cast<std::uint32_t>(list.size());
        list.push_back({w, 1});
      }
    }
  });
}

bool Legality::at_border(VertexNumber v) {
  list_neighbours(v, of_a_);
  return std::any_of(of_a_.begin(), of_a_.end(), [](const Neighbour& n) { return n.faces != 2; });
}

bool Legality::keeps_surface(VertexNumber a, VertexNumber b) {
  const auto irregular = [](const std::vector<Neighbour>& list) {
    return std::any_of(list.begin(), list.end(), [](const Neighbour& n) { return n.faces == 1; });
  };
  list_neighbours(b, of_b_);
  const bool border_b = irregular(of_b_);
  list_neighbours(a, of_a_);  // the last, so that place_ answers for `a`
  if (!stands_in(b, of_a_)) return false;
  const unsigned faces = of_a_[place_[b]].faces;
  if (border_b && faces == 2 && irregular(of_a_)) return false;
  const auto common = std::count_if(of_b_.begin(), of_b_.end(),
                                    [&](const Neighbour& n) { return stands_in(n.vertex, of_a_); });
  if (common != static_cast<std::ptrdiff_t>(faces)) return false;
  // Two faces that would fall onto each other, as the last two of a tetrahedron.
  bool falls_together = false;
  mesh_.for_each_face(b, [&](FaceNumber f) {
    const FaceVertices& face = mesh_.face(f);
    if (falls_together || has(face, a)) return;
    for (const VertexNumber w : face) {
      if (w != b && !stands_in(w, of_a_)) return;
    }
    mesh_.for_each_face(a, [&](FaceNumber g) {
      const FaceVertices& other = mesh_.face(g);
      bool same = true;
      for (const VertexNumber w : face) same &= w == b || has(other, w);
      falls_together |= same;
    });
  });
  return !falls_together;
}

bool Legality::turned_too_far(FaceNumber f, VertexNumber moving, const Point& to) const {
  const Triangle before = mesh_.triangle(f);
  Triangle after = before;
  for (std::size_t i = 0; i < 3; ++i) {
    if (mesh_.face(f)[i] == moving) after[i] = to;
  }
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
    mesh_.for_each_face(moving, [&](FaceNumber f) {
      if (good && !has(mesh_.face(f), other)) good = !turned_too_far(f, moving, edge.position);
    });
  };
  check(edge.removed, edge.kept);
  if (good && edge.position != mesh_.position(edge.kept)) check(edge.kept, edge.removed);
  return good;
}

}  // namespace winnow
