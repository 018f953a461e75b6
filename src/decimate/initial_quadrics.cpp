#include "decimate/initial_quadrics.hpp"

namespace winnow {

void add_faces(const TileMesh& mesh, std::vector<Quadric>& quadrics) {
  for (FaceNumber f = 0; f < mesh.face_count(); ++f) {
    const Triangle triangle = mesh.triangle(f);
    const Point doubled = doubled_area(triangle);
    const double size = length(doubled);
    if (!(size > 0)) continue;
    const Point normal = (1 / size) * doubled;
    // The plane goes through each of its corners.
    for (const VertexNumber v : mesh.face(f)) quadrics[v].add_plane(normal, {}, size / 6);
  }
}

void add_borders(const TileMesh& mesh, double weight, std::vector<Quadric>& quadrics) {
  for (FaceNumber f = 0; f < mesh.face_count(); ++f) {
    const FaceVertices& face = mesh.face(f);
    for (std::size_t i = 0; i < 3; ++i) {
      const VertexNumber a = face[i];
      const VertexNumber b = face[(i + 1) % 3];
      if (mesh.faces_at(a, b) != 1) continue;
      const Point edge = mesh.position(b) - mesh.position(a);
      const Point upright = unit(cross(edge, unit(doubled_area(mesh.triangle(f)))));
      quadrics[a].add_plane(upright, {}, weight * dot(edge, edge));
      quadrics[b].add_plane(upright, {}, weight * dot(edge, edge));
    }
  }
}

}  // namespace winnow
