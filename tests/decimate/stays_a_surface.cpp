// What is closed stays closed, and the count is met.
#include "support/surfaces.hpp"
#include "support/tile_meshes.hpp"

#include <catch2/catch.hpp>

namespace winnow {

namespace {

double volume(const TileMesh& mesh) {
  double sum = 0;
  for (const Triangle& t : test::live_triangles(mesh)) sum += dot(t[0], cross(t[1], t[2])) / 6;
  return sum;
}

}  // namespace

TEST_CASE("a ball of many faces becomes a ball of few") {
  const Refine cost = GENERATE(from_range(test::costs()));
  const double bump = GENERATE(0.0, 0.1);
  const std::uint64_t faces = GENERATE(500, 100);
  CAPTURE(cost, bump, faces);
  TileMesh mesh = test::tile_of(test::ball(30, bump));
  const double before = volume(mesh);
  const auto log = test::decimate(mesh, cost, faces);
  CHECK(mesh.live_faces() == faces);
  const auto edges = test::edges_by_faces(mesh);
  CHECK(edges.size() == 1);
  CHECK(edges.at(2) == faces * 3 / 2);
  CHECK(volume(mesh) == Approx(before).epsilon(0.15));
  for (std::size_t i = 1; i < log.size(); ++i) REQUIRE(log[i].cost >= log[i - 1].cost);
}

TEST_CASE("a cube of many faces keeps its corners") {
  const Refine cost = GENERATE(from_range(test::costs()));
  CAPTURE(cost);
  TileMesh mesh = test::tile_of(test::cube(8));
  test::decimate(mesh, cost, 12);
  CHECK(mesh.live_faces() == 12);
  CHECK(volume(mesh) == Approx(1).epsilon(1e-3));
}

}  // namespace winnow
