// scan and part are closed and turned outwards, whatever the count and the seed.
#include "surface_mesh.hpp"

#include <catch2/catch.hpp>

namespace winnow {

namespace {

void check_closed(const SurfaceMesh& mesh, std::int64_t handles) {
  const auto edges = directed_edges(mesh);
  bool each_once = true;
  for (const auto& [edge, times] : edges) {
    each_once = each_once && times == 1 && edges.count({edge.second, edge.first}) == 1;
  }
  CHECK(each_once);
  // Euler: vertices - edges + faces = 2 - 2 * handles, for one piece whose vertices are all used.
  const auto sum = static_cast<std::int64_t>(mesh.points.size() + mesh.faces.size()) -
                   static_cast<std::int64_t>(edges.size() / 2);
  CHECK(sum == 2 - 2 * handles);
  double volume = 0;
  for (const MeshFace& face : mesh.faces) {
    const auto& [a, b, c] = face.vertex;
    volume += dot(mesh.points[a], cross(mesh.points[b], mesh.points[c])) / 6;
  }
  CHECK(volume > 0);
}

}  // namespace

TEST_CASE("a scan is closed") {
  for (const std::uint64_t faces : {8U, 10U, 12U, 14U, 100U, 999U, 5000U, 20000U}) {
    CAPTURE(faces);
    const SurfaceMesh mesh = mesh_of(generate_options(Surface::scan, faces));
    check_closed(mesh, 0);
  }
  for (const std::uint32_t seed : {2U, 3U, 77U, 4294967295U}) {
    CAPTURE(seed);
    check_closed(mesh_of(generate_options(Surface::scan, 5000, seed)), 0);
  }
}

TEST_CASE("a part is closed and has the one hole") {
  for (const std::uint64_t faces : {8U, 1000U, 5000U, 12345U}) {
    CAPTURE(faces);
    check_closed(mesh_of(generate_options(Surface::part, faces)), 1);
  }
  for (std::uint32_t seed = 2; seed < 40; ++seed) {
    CAPTURE(seed);
    check_closed(mesh_of(generate_options(Surface::part, 1000, seed)), 1);
  }
}

}  // namespace winnow
