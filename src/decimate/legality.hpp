// Whether an edge may be collapsed: what the surface is stays what it is, and no face turns over.
#pragma once

#include "decimate/tile_mesh.hpp"

#include <vector>

namespace winnow {

class Legality {
 public:
  // `least_cosine`: of the angle by which one collapse may turn a face.
  Legality(const TileMesh& mesh, double least_cosine);

  static constexpr std::uint64_t memory(std::uint64_t vertices) { return vertices * sizeof(std::uint32_t); }

  // The link condition (Dey et al. 1999): ends that meet in more vertices than the edge's own faces have
  // would fold the surface onto itself. An edge between two vertices at borders collapses only if
  // it is of the border itself, which it would pinch otherwise. No edge with more than two faces comes about
  // where there was none. A face whose other two edges are border goes as a whole.
  [[nodiscard]] bool keeps_surface(VertexNumber a, VertexNumber b);

  // No face turns by more than the bound or shrinks to a line.
  [[nodiscard]] bool keeps_faces(const Collapse& edge) const;

  // Whether some edge at `v` has more or less than two faces.
  [[nodiscard]] bool at_border(VertexNumber v);

 private:
  struct Neighbour {
    VertexNumber vertex;
    unsigned faces;
  };
  // The neighbours of `v` and the faces on each edge; place_ says where in the list a vertex stands.
  void list_neighbours(VertexNumber v, std::vector<Neighbour>& list);
  [[nodiscard]] bool stands_in(VertexNumber v, const std::vector<Neighbour>& list) const {
    return place_[v] < list.size() && list[place_[v]].vertex == v;
  }
  [[nodiscard]] bool turned_too_far(FaceNumber f, VertexNumber moving, const Point& to) const;

  const TileMesh& mesh_;
  double least_cosine_;
  std::vector<std::uint32_t> place_;
  std::vector<Neighbour> of_a_, of_b_;
};

}  // namespace winnow
