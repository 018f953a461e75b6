#include "decimate/legality.hpp"

#include <algorithm>
#include <iterator>
#include <span>

namespace winnow {

bool Legality::at_boundary(VertexNumber v) {
  met_.clear();
  mesh_.for_each_corner(v, [&](FaceNumber, VertexNumber w, VertexNumber x) {
    met_.insert(met_.end(), {w, x});
  });
  std::sort(met_.begin(), met_.end());
  for (auto first = met_.begin(); first != met_.end();) {
    const auto end =
        std::find_if(first, met_.end(), [first](VertexNumber w) { return w != *first; });
    if (end - first != 2) return true;
    first = end;
  }
  return false;
}

bool Legality::keeps_surface(const EdgeStar& star) {
  const bool hub = mesh_.hub(star.kept());
  const TileMesh::Meeting meeting =
      hub ? mesh_.meeting_at_hub(star.kept(), star.of_kept(), star.removed(), star.of_removed())
          : mesh_.meeting(star.of_kept(), star.removed(), star.of_removed());
  if (meeting.faces == 0 || meeting.common != meeting.faces || meeting.falls_together) return false;
  if (!leaves_faces(star)) return false;
  if (meeting.faces != 2 || mesh_.all_edges_even(star.removed())) return true;
  // A hub may be at a boundary: to know would take a walk.
  return mesh_.open_neighbours(star.removed()).empty() ||
         (!hub && mesh_.open_neighbours(star.kept()).empty());
}

bool Legality::find_change(const EdgeStar& star, SurfaceChange& change) {
  change = {};
  if (mesh_.hub(star.kept()) || !leaves_faces(star)) return false;
  const auto meet = [](std::span<const StarFace> faces, std::vector<VertexNumber>& met) {
    met.clear();
    for (const StarFace& face : faces) met.insert(met.end(), {face.w, face.x});
    std::sort(met.begin(), met.end());
    met.erase(std::unique(met.begin(), met.end()), met.end());
  };
  meet(star.of_kept(), met_);
  meet(star.of_removed(), met_by_other_);
  std::set_intersection(met_.begin(), met_.end(), met_by_other_.begin(), met_by_other_.end(),
                        std::back_inserter(change.across));
  std::size_t at_edge = 0;
  for (const StarFace& face : star.of_kept()) {
    if (face.stays) continue;
    ++at_edge;
    std::erase(change.across, face.w == star.removed() ? face.x : face.w);
  }
  for (const StarFace& face : star.of_removed()) {
    for (const StarFace& other : star.of_kept()) {
      if (!other.stays || std::minmax(face.w, face.x) != std::minmax(other.w, other.x)) continue;
      change.pairs.push_back({star.removed(), face.w, face.x});
      break;
    }
  }
  // An edge that was postponed may be one no more.
  if (at_edge == 0 || falls_together_whole(star, change)) return false;
  change.pinches_boundary = at_edge == 2 && !mesh_.open_neighbours(star.removed()).empty() &&
                            !mesh_.open_neighbours(star.kept()).empty();
  return true;
}

// Whether the star is all of the piece, and all faces that stay are in pairs.
bool Legality::falls_together_whole(const EdgeStar& star, const SurfaceChange& change) const {
  const auto stays = [](const StarFace& face) { return face.stays; };
  const auto left = std::count_if(star.faces().begin(), star.faces().end(), stays);
  if (change.pairs.empty() || static_cast<std::size_t>(left) != 2 * change.pairs.size())
    return false;
  return std::all_of(star.faces().begin(), star.faces().end(), [&](const StarFace& face) {
    const auto all_here = [&](VertexNumber v) {
      if (v == star.kept() || v == star.removed()) return true;
      const auto here = std::count_if(star.faces().begin(), star.faces().end(),
                                      [v](const StarFace& f) { return f.w == v || f.x == v; });
      return mesh_.degree(v) == static_cast<std::uint32_t>(here);
    };
    return all_here(face.w) && all_here(face.x);
  });
}

void add_change(const TileMesh& mesh, const EdgeStar& star, const SurfaceChange& change,
                TopologyChanges& changes) {
  const bool open = mesh.faces_at(star.kept(), star.removed(), 2) == 1;
  for (const VertexNumber v : change.across) {
    const auto is_open = [&](VertexNumber end) { return mesh.faces_at(end, v, 2) == 1; };
    const bool hole = open && is_open(star.kept()) && is_open(star.removed());
    ++(hole ? changes.holes : changes.handles);
  }
}

PieceLoss loss_of(const TileMesh& mesh, const EdgeStar& star, const Collapse& edge,
                  const SurfaceChange& change) {
  const Point& a = mesh.position(star.kept());
  const Point& b = mesh.position(star.removed());
  PieceLoss loss;
  for (const VertexNumber c : change.across) loss.add({a, b, mesh.position(c)});
  for (const FaceVertices& face : change.pairs)
    loss.add({edge.position, mesh.position(face[1]), mesh.position(face[2])}, 2);
  if (change.pinches_boundary) {
    const double square = dot(b - a, b - a);
    loss.boundary = square * square / 12;
  }
  return loss;
}

PieceLoss loss_by_turning(const TileMesh& mesh, const EdgeStar& star, const Collapse& edge,
                          const VertexPlaces& places) {
  PieceLoss loss;
  for (const StarFace& face : star.faces())
    loss.area += length(doubled_area(places.triangle(mesh.face(face.number)))) / 2;
  const Point along = places[edge.removed] - places[edge.kept];
  loss.surface = loss.area * dot(along, along);
  return loss;
}

// Whether the piece has a face that is not at the edge.
bool Legality::leaves_faces(const EdgeStar& star) const {
  const std::size_t at_edge = star.of_kept().size();
  if (star.faces().size() != at_edge || mesh_.degree(star.kept()) != at_edge) return true;
  for (const StarFace& face : star.of_kept()) {
    const VertexNumber across = face.w == star.removed() ? face.x : face.w;
    if (face.stays || mesh_.degree(across) > 1) return true;
  }
  return false;
}

bool Legality::keeps_faces(EdgeStar& star, const Collapse& edge, const VertexPlaces& places) const {
  star.move(places, edge.position, least_cosine_);
  // Faces that do not move may be as thin as they are.
  const bool moves = edge.position != places[edge.kept];
  bool opened = false;
  for (std::size_t face = moves ? 0 : star.of_kept().size(); face < star.faces().size(); ++face) {
    if (star.turned(face)) return false;
    opened |= star.opened(face);
  }
  return !opened || opens_outwards(star, edge, places);
}

bool Legality::opens_outwards(const EdgeStar& star, const Collapse& edge,
                              const VertexPlaces& places) {
  Point sum{};
  for (const StarFace& face : star.of_kept())
    sum = sum + doubled_area({places[edge.kept], places[face.w], places[face.x]});
  for (const StarFace& face : star.of_removed())
    sum = sum + doubled_area({places[edge.removed], places[face.w], places[face.x]});
  for (std::size_t face = 0; face < star.faces().size(); ++face) {
    if (!star.opened(face)) continue;
    const auto [number, w, x, stays] = star.faces()[face];
    if (!(dot(doubled_area({edge.position, places[w], places[x]}), sum) > 0)) return false;
  }
  return true;
}

}  // namespace winnow
