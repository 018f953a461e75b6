// The faces around every vertex form one fan: boxes of a part do not touch in an edge or in a
// corner alone.
#include "surface_mesh.hpp"

#include <catch2/catch.hpp>

namespace winnow {

TEST_CASE("each vertex of a closed surface has one ring of faces") {
  for (const Surface surface : {Surface::scan, Surface::part}) {
    for (std::uint32_t seed = 1; seed < 10; ++seed) {
      CAPTURE(static_cast<int>(surface), seed);
      const SurfaceMesh mesh = mesh_of(generate_options(surface, 3000, seed));
      std::vector<std::map<std::uint64_t, std::uint64_t>> next(mesh.points.size());
      for (const MeshFace& face : mesh.faces) {
        for (std::size_t n = 0; n < 3; ++n) {
          next[face.vertex[n]][face.vertex[(n + 1) % 3]] = face.vertex[(n + 2) % 3];
        }
      }
      bool one_ring = true;
      for (const auto& around : next) {
        if (around.empty()) {
          one_ring = false;
          continue;
        }
        std::size_t steps = 0;
        std::uint64_t at = around.begin()->first;
        do {
          at = around.at(at);
          ++steps;
        } while (at != around.begin()->first && steps <= around.size());
        one_ring = one_ring && steps == around.size();
      }
      CHECK(one_ring);
    }
  }
}

}  // namespace winnow
