// A vertex with very many faces does not stop sweeps: what is beside it is collapsed, also into it.
#include "decimate/sweeps.hpp"
#include "support/surfaces.hpp"
#include "support/tile_meshes.hpp"

#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

#include <catch2/catch.hpp>

namespace winnow {

namespace {

// A ball of rings, with a pole above and one below: vertices 0 and 1.
TileMesh ball_of_rings(std::size_t around, std::size_t rings) {
  std::vector<Point> positions{{0, 0, 1}, {0, 0, -1}};
  for (std::size_t ring = 1; ring <= rings; ++ring) {
    const double down =
        std::numbers::pi * static_cast<double>(ring) / static_cast<double>(rings + 1);
    for (std::size_t i = 0; i < around; ++i) {
      const double along =
          2 * std::numbers::pi * static_cast<double>(i) / static_cast<double>(around);
      positions.push_back(
          {std::sin(down) * std::cos(along), std::sin(down) * std::sin(along), std::cos(down)});
    }
  }
  const auto at = [&](std::size_t ring, std::size_t i) {
    return static_cast<VertexNumber>(2 + ring * around + i % around);
  };
  std::vector<FaceVertices> faces;
  for (std::size_t i = 0; i < around; ++i) {
    faces.push_back({0, at(0, i), at(0, i + 1)});
    faces.push_back({1, at(rings - 1, i + 1), at(rings - 1, i)});
    for (std::size_t ring = 0; ring + 1 < rings; ++ring) {
      faces.push_back({at(ring, i), at(ring + 1, i), at(ring + 1, i + 1)});
      faces.push_back({at(ring, i), at(ring + 1, i + 1), at(ring, i + 1)});
    }
  }
  std::vector<std::uint8_t> locked(positions.size(), free_vertex);
  return {std::move(positions), std::move(faces), std::move(locked), false};
}

}  // namespace

TEST_CASE("a vertex with very many faces does not stop sweeps") {
  TileMesh mesh = ball_of_rings(200, 50);
  const std::uint64_t before = mesh.live_faces();
  Sweeps sweeps(mesh, false, {0.2, rounding_of_double});
  std::size_t into_poles = 0;
  const CollapseLimits limits{2000, std::numeric_limits<double>::infinity(), 2000};
  CHECK(
      sweeps.run(limits, [&](const DoneCollapse& done) { into_poles += done.edge.kept < 2; }, {}));
  CHECK(before == 20000);
  CHECK(mesh.live_faces() <= 2000);
  CHECK(into_poles > 0);
  const auto edges = test::edges_by_faces(mesh);
  CHECK(edges.size() == 1);
  CHECK(edges.at(2) == mesh.live_faces() / 2 * 3);
}

}  // namespace winnow
