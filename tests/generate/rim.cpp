// A terrain is open at the rim of its rectangle and nowhere else.
#include "surface_mesh.hpp"

#include <catch2/catch.hpp>

namespace winnow {

TEST_CASE("the boundary of a terrain is its rim") {
  for (const std::uint64_t faces : {8U, 50U, 1000U, 20000U}) {
    CAPTURE(faces);
    const SurfaceMesh mesh = mesh_of(generate_options(Surface::terrain, faces));
    const auto edges = directed_edges(mesh);
    const auto on_rim = [&](std::uint64_t vertex) {
      const Point& point = mesh.points[vertex];
      return std::abs(point[0]) == 1 || std::abs(point[1]) == 0.75;
    };
    std::size_t rim = 0;
    bool right = true;
    double around = 0;
    for (const auto& [edge, times] : edges) {
      right = right && times == 1;
      if (edges.count({edge.second, edge.first}) == 1) continue;
      ++rim;
      right = right && on_rim(edge.first) && on_rim(edge.second);
      Point step = mesh.points[edge.first] - mesh.points[edge.second];
      step[2] = 0;
      around += length(step);
    }
    CHECK(right);
    CHECK(around == Approx(7));
    const std::size_t all = (edges.size() - rim) / 2 + rim;
    CHECK(mesh.points.size() + mesh.faces.size() == all + 1);  // a disk
  }
}

TEST_CASE("a terrain is seen from above and has flat lakes") {
  const SurfaceMesh mesh = mesh_of(generate_options(Surface::terrain, 20000));
  bool upwards = true;
  std::size_t flat = 0;
  for (const MeshFace& face : mesh.faces) {
    const auto& [a, b, c] = face.vertex;
    const Point normal = doubled_area({mesh.points[a], mesh.points[b], mesh.points[c]});
    upwards = upwards && normal[2] > 0;
    if (normal[0] == 0 && normal[1] == 0) ++flat;
  }
  CHECK(upwards);
  CHECK(flat > mesh.faces.size() / 50);
  CHECK(flat < mesh.faces.size() / 2);
}

}  // namespace winnow
