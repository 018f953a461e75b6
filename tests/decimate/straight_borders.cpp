// Boundaries that are straight stay where they are.
#include "support/surfaces.hpp"
#include "support/tile_meshes.hpp"

#include <cmath>

#include <catch2/catch.hpp>

namespace winnow {

TEST_CASE("a square sheet stays a square") {
  const Refine cost = GENERATE(from_range(test::costs()));
  const double bump = GENERATE(0.0, 0.1);
  CAPTURE(cost, bump);
  std::vector<Triangle> triangles = test::sheet(16);
  for (Triangle& t : triangles) {
    for (Point& p : t)
      p[2] = bump * p[0] * (1 - p[0]) * p[1] * (1 - p[1]) * std::sin(9 * p[0] + 5 * p[1]);
  }
  TileMesh mesh = test::tile_of(triangles);
  test::decimate(mesh, cost, 40);
  CHECK(mesh.live_faces() <= 41);
  double area = 0;
  for (const Triangle& t : test::live_triangles(mesh)) {
    const double above = doubled_area(t)[2] / 2;
    CHECK(above > 0);
    area += above;
  }
  CHECK(area == Approx(1).epsilon(1e-4));
}

}  // namespace winnow
