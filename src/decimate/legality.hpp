// Whether an edge may be collapsed: what the surface is stays what it is, and no face turns over.
#pragma once

#include "decimate/edge_star.hpp"
#include "decimate/tile_mesh.hpp"

#include <vector>

namespace winnow {

class Legality {
 public:
  // `least_cosine`: of the angle by which one collapse may turn a face.
  Legality(TileMesh& mesh, double least_cosine) : mesh_(mesh), least_cosine_(least_cosine) {}

  // The link condition (Dey et al. 1999): ends that meet in more vertices than the edge's own faces have
  // would fold the surface onto itself. An edge between two vertices at borders collapses only if
  // it is of the border itself, which it would pinch otherwise. No edge with more than two faces comes about
  // where there was none. A face whose other two edges are border goes, unless nothing of its piece were left.
  [[nodiscard]] bool keeps_surface(const EdgeStar& star);

  // No face turns by more than the bound or shrinks to a line. One that is thinner than rounding has nothing
  // to turn from; where it gets an area, that looks the way of the faces around the edge. `star`: that of the
  // edge; it is moved there.
  [[nodiscard]] bool keeps_faces(EdgeStar& star, const Collapse& edge) const;

  // Whether some edge at `v` has more or less than two faces.
  [[nodiscard]] bool at_border(VertexNumber v);

 private:
  [[nodiscard]] bool leaves_faces(const EdgeStar& star) const;
  [[nodiscard]] bool opens_outwards(const EdgeStar& star, const Collapse& edge) const;
  TileMesh& mesh_;
  double least_cosine_;
  std::vector<VertexNumber> met_;
};

}  // namespace winnow
