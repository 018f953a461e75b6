// Faces on their way into the order of their vertices.
#pragma once

#include "mesh/face_vertices.hpp"

namespace winnow {

struct OrderedFace {
  FaceVertices vertices;  // the lowest first

  static bool before(const OrderedFace& a, const OrderedFace& b) { return a.vertices < b.vertices; }
  static bool combine(OrderedFace&, const OrderedFace&) { return false; }
};

}  // namespace winnow
