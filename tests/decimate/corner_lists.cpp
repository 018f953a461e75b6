// What every vertex is told of its faces.
#include "decimate/corner_lists.hpp"

#include "support/surfaces.hpp"
#include "support/tile_meshes.hpp"

#include <algorithm>
#include <utility>

#include <catch2/catch.hpp>

namespace winnow {

TEST_CASE("a vertex has the other corners of each of its faces, in their winding") {
  const TileMesh mesh = test::tile_of(test::ball(12));
  std::vector<SurvivingFace> faces;
  for (FaceNumber f = 0; f < mesh.face_count(); ++f) {
    if (f % 3 != 0) faces.push_back({mesh.face(f), f});
  }
  CornerLists corners(mesh.vertex_count());
  // Made twice: nothing is left of the first.
  corners.make(std::span<const SurvivingFace>(faces).first(7));
  corners.make(std::span<const SurvivingFace>(faces));
  for (VertexNumber v = 0; v < mesh.vertex_count(); ++v) {
    std::vector<std::pair<VertexNumber, VertexNumber>> told, expected;
    for (const auto [w, x] : corners.of(v)) told.emplace_back(w, x);
    for (const SurvivingFace& face : faces) {
      for (std::size_t i = 0; i < 3; ++i) {
        if (face.vertices[i] == v)
          expected.emplace_back(face.vertices[(i + 1) % 3], face.vertices[(i + 2) % 3]);
      }
    }
    REQUIRE(told == expected);
    REQUIRE(corners.degree(v) == told.size());
  }
}

}  // namespace winnow
