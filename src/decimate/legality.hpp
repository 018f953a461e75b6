// Whether an edge may be collapsed: what the surface is stays what it is, and no face turns over.
#pragma once

#include "decimate/edge_star.hpp"
#include "decimate/piece.hpp"
#include "decimate/tile_mesh.hpp"

#include <vector>

namespace winnow {

// Beside the edge's own faces, the ends of an edge meet in other vertices, faces of one fall onto
// faces of the other, or the edge runs from boundary to boundary.
struct SurfaceChange {
  std::vector<VertexNumber>
      across;  // triangles of such a vertex and the edge have no face and close
  std::vector<FaceVertices> pairs;  // of the end that goes; each falls onto one of the other
  bool pinches_boundary = false;

  [[nodiscard]] bool none() const { return across.empty() && pairs.empty() && !pinches_boundary; }
};

// Counts the handles and the holes that close.
void add_change(const TileMesh& mesh, const EdgeStar& star, const SurfaceChange& change,
                TopologyChanges& changes);

// What such a collapse loses: a triangle that closes goes or comes as a piece would, and so does a
// face that falls onto another. An edge between two boundaries is as far off as it is long.
PieceLoss loss_of(const TileMesh& mesh, const EdgeStar& star, const Collapse& edge,
                  const SurfaceChange& change);
// And where faces turn by more than they may: as if all around the edge were off by its length.
PieceLoss loss_by_turning(const TileMesh& mesh, const EdgeStar& star, const Collapse& edge,
                          const VertexPlaces& places);
inline PieceLoss loss_by_turning(const TileMesh& mesh, const EdgeStar& star, const Collapse& edge) {
  return loss_by_turning(mesh, star, edge, mesh.places());
}

class Legality {
 public:
  // `least_cosine`: of the angle by which one collapse may turn a face.
  Legality(TileMesh& mesh, double least_cosine) : mesh_(mesh), least_cosine_(least_cosine) {}

  // The link condition (Dey et al. 1999): ends that meet in more vertices than the edge's own faces
  // have would fold the surface onto itself. An edge between two vertices at boundaries collapses
  // only if it is of the boundary itself, which it would pinch otherwise. No edge with more than
  // two faces comes about where there was none. A face whose other two edges are boundary goes,
  // unless nothing of its piece were left.
  [[nodiscard]] bool keeps_surface(const EdgeStar& star);

  // What a collapse that does not keep the surface would change. False where it is not to be made
  // at all: a whole piece goes otherwise, and around a hub it would take a walk to know.
  [[nodiscard]] bool find_change(const EdgeStar& star, SurfaceChange& change);

  // No face turns by more than the bound or shrinks to a line. One that is thinner than rounding
  // has nothing to turn from; where it gets an area, that looks the way of the faces around the
  // edge. `star`: that of the edge; it is moved there.
  [[nodiscard]] bool keeps_faces(EdgeStar& star, const Collapse& edge) const {
    return keeps_faces(star, edge, mesh_.places());
  }
  [[nodiscard]] bool keeps_faces(EdgeStar& star, const Collapse& edge,
                                 const VertexPlaces& places) const;

  // Whether some edge at `v` has more or less than two faces.
  [[nodiscard]] bool at_boundary(VertexNumber v);

 private:
  [[nodiscard]] bool leaves_faces(const EdgeStar& star) const;
  [[nodiscard]] bool falls_together_whole(const EdgeStar& star, const SurfaceChange& change) const;
  [[nodiscard]] static bool opens_outwards(const EdgeStar& star, const Collapse& edge,
                                           const VertexPlaces& places);
  TileMesh& mesh_;
  double least_cosine_;
  std::vector<VertexNumber> met_, met_by_other_;
};

}  // namespace winnow
