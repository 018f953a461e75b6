// How much of a feature an edge is in one frame (Zhang and Wu, section 3.2).
//
// Two of their weights are corrected, each by a shift:
// - A complex edge has at least three faces. Its weight is printed as (faces - 3), which is 0 for
//   nearly all of them. Here it is (faces - 2): what it has beyond an edge of a surface.
// - A boundary edge has the largest cosine of the angles between it and the boundary edges beside
//   it. Along a straight boundary these are 180 degrees, so the weight is -1, which makes the edge
//   free, and with k2 above 1 less than free. Here it is 1 + the cosine: 0 along a straight
//   boundary, 1 at a right angle, 2 at a spike.
#pragma once

#include "decimate/tile_mesh.hpp"

#include <cstdint>

namespace winnow {

// Each edge is in the first of these classes that it meets.
enum class EdgeClass : std::uint8_t {
  complex,            // of three faces or more
  boundary,           // of one face
  boundary_incident,  // an end is at a boundary: a quarter for each boundary edge at the ends
  sharp,              // its faces meet at less than 60 degrees: the sine of that angle
  interior            // 0
};

struct EdgeFeature {
  EdgeClass kind = EdgeClass::interior;
  double weight = 0;
};

// Asks for neighbours of both ends, neither of which is a hub.
EdgeFeature feature_of(TileMesh& mesh, const VertexPlaces& places, VertexNumber a, VertexNumber b);

}  // namespace winnow
