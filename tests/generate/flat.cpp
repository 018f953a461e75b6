// The flat faces of a part are flat to the last bit, and its edges are sharp.
#include "surface_mesh.hpp"

#include <algorithm>
#include <set>

#include <catch2/catch.hpp>

namespace winnow {

TEST_CASE("every face of a part lies in a plane across an axis") {
  for (std::uint32_t seed = 1; seed < 6; ++seed) {
    CAPTURE(seed);
    const SurfaceMesh mesh = mesh_of(generate_options(Surface::part, 30000, seed));
    std::array<std::set<double>, 3> planes;
    bool flat = true;
    for (const MeshFace& face : mesh.faces) {
      const auto& [a, b, c] = face.vertex;
      int across = 0;
      for (std::size_t axis = 0; axis < 3; ++axis) {
        if (mesh.points[a][axis] != mesh.points[b][axis] ||
            mesh.points[a][axis] != mesh.points[c][axis])
          continue;
        planes[axis].insert(mesh.points[a][axis]);
        ++across;
      }
      flat = flat && across == 1;
    }
    CHECK(flat);
    // Many faces, few planes.
    CHECK(planes[0].size() + planes[1].size() + planes[2].size() < 40);
    // Thin walls: two planes that are nearer to each other than a fortieth of the part.
    double thinnest = 2;
    for (auto at = planes[0].begin(); std::next(at) != planes[0].end(); ++at) {
      thinnest = std::min(thinnest, *std::next(at) - *at);
    }
    CHECK(thinnest < 0.05);
  }
}

}  // namespace winnow
