#include "decimate/legality.hpp"

#include <algorithm>

namespace winnow {

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

bool Legality::keeps_surface(const EdgeStar& star) {
  const TileMesh::Meeting meeting = mesh_.meeting(star.of_kept(), star.removed(), star.of_removed());
  if (meeting.faces == 0 || meeting.common != meeting.faces || meeting.falls_together) return false;
  if (meeting.faces != 2 || mesh_.all_edges_even(star.removed())) return true;
  const auto open = [](std::ptrdiff_t faces) { return faces == 1; };
  return !some_edge_has(star.removed(), open) || !some_edge_has(star.kept(), open);
}

bool Legality::keeps_faces(EdgeStar& star, const Collapse& edge) const {
  star.move(mesh_, edge.position, least_cosine_);
  // Faces that do not move may be as thin as they are.
  const bool moves = edge.position != mesh_.position(edge.kept);
  for (std::size_t face = moves ? 0 : star.of_kept().size(); face < star.faces().size(); ++face) {
    if (star.turned(face)) return false;
  }
  return true;
}

}  // namespace winnow
