// Quadrics of a mesh that nothing has been collapsed in.
#pragma once

#include "base/quadric.hpp"
#include "decimate/tile_mesh.hpp"

#include <vector>

namespace winnow {

// Of every vertex the planes of its faces, each with a third of the face's area.
void add_faces(const TileMesh& mesh, std::vector<Quadric>& quadrics);

// To both ends of every edge with one face the plane through it, upright on the face, so that the border
// keeps its line: with the square of the edge's length times `weight`.
void add_borders(const TileMesh& mesh, double weight, std::vector<Quadric>& quadrics);

}  // namespace winnow
