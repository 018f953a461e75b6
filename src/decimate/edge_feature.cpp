#include "decimate/edge_feature.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace winnow {

namespace {

double cosine_between(const Point& a, const Point& b) {
  const double lengths = length(a) * length(b);
  return lengths > 0 ? dot(a, b) / lengths : 0;
}

// Of the angles between the boundary edge from `a` to `b` and the others at `a`, the largest.
double sharpest_turn(TileMesh& mesh, const VertexPlaces& places, VertexNumber a, VertexNumber b) {
  double largest = -1;
  for (const VertexNumber c : mesh.open_neighbours(a)) {
    if (c == b) continue;
    largest = std::max(largest, cosine_between(places[b] - places[a], places[c] - places[a]));
  }
  return largest;
}

}  // namespace

EdgeFeature feature_of(TileMesh& mesh, const VertexPlaces& places, VertexNumber a, VertexNumber b) {
  unsigned faces = 0;
  std::array<Point, 2> normals{};
  mesh.for_each_corner(a, [&](FaceNumber f, VertexNumber w, VertexNumber x) {
    if (w != b && x != b) return;
    if (faces < 2) {
      normals.at(faces) = doubled_area(places.triangle(mesh.face(f)));
      // Where both faces run along the edge in one sense, one is seen from its other side.
      if (x == b) normals.at(faces) = -1.0 * normals.at(faces);
    }
    ++faces;
  });
  if (faces > 2) return {EdgeClass::complex, static_cast<double>(faces) - 2};
  if (faces == 1) {
    const double cosine =
        std::max(sharpest_turn(mesh, places, a, b), sharpest_turn(mesh, places, b, a));
    return {EdgeClass::boundary, 1 + cosine};
  }
  const std::size_t open = mesh.open_neighbours(a).size();
  const std::size_t all = open + mesh.open_neighbours(b).size();
  if (all > 0) return {EdgeClass::boundary_incident, static_cast<double>(all) / 4};
  // Their normals, both as of faces that run from `a` to `b`, are as far apart as the faces are:
  // opposite where the surface is flat.
  const double cosine = cosine_between(normals[0], normals[1]);
  constexpr double cosine_of_sharpest = 0.5;
  if (cosine <= cosine_of_sharpest) return {};
  return {EdgeClass::sharp, std::sqrt(std::max(0.0, 1 - cosine * cosine))};
}

}  // namespace winnow
