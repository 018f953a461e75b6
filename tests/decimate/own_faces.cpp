// What a vertex offers depends on its own faces alone, so that tiles change nothing.
#include "decimate/importance_cost.hpp"
#include "decimate/volume_cost.hpp"
#include "support/surfaces.hpp"
#include "support/tile_meshes.hpp"

#include <catch2/catch.hpp>

namespace winnow {

TEMPLATE_TEST_CASE("a vertex with its faces alone offers what it offers in the mesh", "",
                   VolumeCost, ImportanceCost) {
  TileMesh whole = test::tile_of(test::ball(14, 0.2));
  TestType cost(whole, 0, false);
  for (VertexNumber v = 0; v < whole.vertex_count(); ++v) {
    std::vector<Point> positions;
    for (VertexNumber w = 0; w < whole.vertex_count(); ++w) positions.push_back(whole.position(w));
    std::vector<FaceVertices> faces;
    whole.for_each_face(v, [&](FaceNumber f) { faces.push_back(whole.face(f)); });
    TileMesh alone(positions, faces, std::vector<std::uint8_t>(positions.size(), 0));
    TestType cost_alone(alone, 0, false);
    const Candidate in_mesh = cost.best(v, Candidate::none_yet());
    const Candidate by_itself = cost_alone.best(v, Candidate::none_yet());
    REQUIRE(in_mesh.exists());
    REQUIRE(by_itself.partner == in_mesh.partner);
    REQUIRE(by_itself.cost == in_mesh.cost);
  }
}

}  // namespace winnow
