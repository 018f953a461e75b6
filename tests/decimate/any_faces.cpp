// Faces that make no surface are survived, and none of it gets worse; a collapse can be repeated.
#include "support/random.hpp"
#include "support/surfaces.hpp"
#include "support/tile_meshes.hpp"

#include <cstring>
#include <set>

#include <catch2/catch.hpp>

namespace winnow {

namespace {

// Faces between any of a few vertices, some in the same place, some locked.
TileMesh random_faces(std::uint64_t seed) {
  test::Random random(seed);
  const std::uint64_t vertices = random.between(4, 40);
  std::vector<Point> positions(vertices);
  for (Point& p : positions)
    p = {random.unit(), random.unit(), random.chance(0.3) ? 0 : random.unit()};
  for (Point& p : positions) {
    if (random.chance(0.1)) p = positions[random.below(vertices)];
  }
  std::vector<std::uint8_t> locked(vertices);
  for (auto& byte : locked) byte = random.chance(0.1);
  std::vector<FaceVertices> faces;
  std::set<std::set<VertexNumber>> seen;
  for (std::uint64_t i = random.below(4 * vertices) + 1; i > 0; --i) {
    FaceVertices face{};
    for (VertexNumber& v : face) v = static_cast<VertexNumber>(random.below(vertices));
    const std::set<VertexNumber> key(face.begin(), face.end());
    if (key.size() == 3 && seen.insert(key).second) faces.push_back(face);
  }
  return {positions, faces, locked};
}

std::size_t edges_of_more_than_two(const TileMesh& mesh) {
  std::size_t sum = 0;
  for (const auto& [faces, edges] : test::edges_by_faces(mesh)) sum += faces > 2 ? edges : 0;
  return sum;
}

}  // namespace

TEST_CASE("faces that make no surface are survived") {
  const Refine cost = GENERATE(from_range(test::costs()));
  CAPTURE(cost);
  for (std::uint64_t seed = 0; seed < 300; ++seed) {
    TileMesh mesh = random_faces(seed);
    const std::size_t before = edges_of_more_than_two(mesh);
    const auto log = test::decimate(mesh, cost, 0);
    REQUIRE(edges_of_more_than_two(mesh) <= before);
    for (const DoneCollapse& done : log) {
      REQUIRE_FALSE(mesh.locked(done.edge.removed));
      REQUIRE_FALSE(mesh.has_faces(done.edge.removed));
    }
  }
}

TEST_CASE("repeated collapses leave the same mesh, which remembers the same") {
  DecimationSettings settings;
  settings.cost = GENERATE(from_range(test::costs()));
  CAPTURE(settings.cost);
  const auto triangles = test::ball(16, 0.2);
  const std::size_t size = Decimation::state_size(settings);
  std::vector<Collapse> edges;
  TileMesh mesh = test::tile_of(triangles);
  const auto decimation = Decimation::make(mesh, {}, settings);
  decimation->run({300}, [&](const DoneCollapse& done) {
    edges.push_back(done.edge);
    return true;
  });
  TileMesh again = test::tile_of(triangles);
  const auto repeated = Decimation::make(again, {}, settings);
  for (const Collapse& edge : edges) repeated->repeat(edge);
  CHECK(test::live_triangles(mesh) == test::live_triangles(again));
  std::vector<std::byte> one(size), other(size);
  for (VertexNumber v = 0; v < mesh.vertex_count(); ++v) {
    decimation->save(v, one.data());
    repeated->save(v, other.data());
    REQUIRE(one == other);
  }
}

}  // namespace winnow
