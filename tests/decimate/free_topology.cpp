// With a free topology any count is met, handles and holes close, and no face is left twice or
// without a side.
#include "support/surfaces.hpp"
#include "support/tile_meshes.hpp"

#include <algorithm>
#include <array>
#include <set>

#include <catch2/catch.hpp>

namespace winnow {

using namespace test;

namespace {

DecimationSettings free_settings(Refine cost = Refine::quadric) {
  DecimationSettings settings;
  settings.cost = cost;
  settings.single = false;
  settings.free_topology = true;
  return settings;
}

TopologyChanges collapse(TileMesh& mesh, const DecimationSettings& settings, std::uint64_t faces,
                         std::vector<Collapse>* edges = nullptr) {
  const auto decimation = Decimation::make(mesh, {}, settings);
  decimation->run({faces}, [&](const DoneCollapse& done) {
    if (edges != nullptr) edges->push_back(done.edge);
  });
  return decimation->changes();
}

void check_faces(const TileMesh& mesh) {
  std::set<std::set<VertexNumber>> seen;
  std::uint64_t faces = 0;
  for (FaceNumber f = 0; f < mesh.face_count(); ++f) {
    if (mesh.removed(f)) continue;
    const std::set<VertexNumber> corners(mesh.face(f).begin(), mesh.face(f).end());
    REQUIRE(corners.size() == 3);
    REQUIRE(seen.insert(corners).second);
    for (const VertexNumber v : corners) REQUIRE(finite(mesh.position(v)));
    ++faces;
  }
  REQUIRE(faces == mesh.live_faces());
}

std::vector<Triangle> with_hole(std::size_t n, double side) {
  std::vector<Triangle> faces;
  for (const Triangle& face : sheet(n)) {
    const Point middle = (1.0 / 3) * (face[0] + face[1] + face[2]);
    if (std::max(std::abs(middle[0] - 0.5), std::abs(middle[1] - 0.5)) > side / 2)
      faces.push_back(face);
  }
  return faces;
}

}  // namespace

TEST_CASE("a ring loses its handle where the count asks for that, and not before") {
  const Refine cost = GENERATE(from_range(test::costs()));
  for (const double tube : {0.1, 0.3, 0.8}) {
    CAPTURE(static_cast<int>(cost), tube);
    TileMesh few = tile_of(torus(24, 12, tube));
    const TopologyChanges changes = collapse(few, free_settings(cost), 8);
    CHECK(few.live_faces() <= 8);
    CHECK(few.live_faces() >= 4);
    CHECK(changes.handles > 0);
    check_faces(few);
    TileMesh many = tile_of(torus(24, 12, tube));
    CHECK(collapse(many, free_settings(cost), 100).handles == 0);
    CHECK(many.live_faces() == 100);
    CHECK(edges_by_faces(many) == std::map<unsigned, std::size_t>{{2, 150}});
  }
}

TEST_CASE("a small hole closes and a large one stays") {
  for (const double side : {0.12, 0.7}) {
    CAPTURE(side);
    // Beside something round, which is worth more faces than the hole.
    std::vector<Triangle> faces = with_hole(20, side);
    for (const Triangle& face : placed(ball(20, 0.3), 3, {10, 0, 0})) faces.push_back(face);
    TileMesh both = tile_of(faces);
    const TopologyChanges changes = collapse(both, free_settings(), 60);
    CHECK(both.live_faces() <= 60);
    CHECK(changes.holes == (side < 0.5 ? 1 : 0));
    check_faces(both);
  }
}

TEST_CASE("within an error holes close that are smaller than it") {
  for (const double side : {0.15, 0.5}) {
    CAPTURE(side);
    DecimationSettings settings = free_settings();
    settings.error = 0.3;
    TileMesh mesh = tile_of(with_hole(20, side));
    CHECK((collapse(mesh, settings, 0).holes > 0) == (side < 0.3));
    settings.free_topology = false;
    TileMesh kept = tile_of(with_hole(20, side));
    CHECK(collapse(kept, settings, 0).holes == 0);
  }
}

TEST_CASE("any faces become few, none twice, and a list of their collapses can be repeated") {
  DecimationSettings settings = free_settings(GENERATE(from_range(test::costs())));
  settings.keep_pieces = GENERATE(false, true);
  if (settings.cost == Refine::quadric && GENERATE(false, true)) settings.error = 0.4;
  CAPTURE(static_cast<int>(settings.cost), settings.keep_pieces, settings.error.has_value());
  for (std::uint64_t seed = 0; seed < 200; ++seed) {
    CAPTURE(seed);
    Random random(seed);
    const auto vertices = static_cast<VertexNumber>(random.between(4, 40));
    const std::vector<FaceVertices> faces = random_mesh(random, vertices, 4 * vertices);
    std::vector<Point> positions(vertices);
    for (Point& p : positions)
      p = {random.unit(), random.unit(), random.chance(0.3) ? 0 : random.unit()};
    const auto mesh_of = [&] {
      return TileMesh(positions, faces, std::vector<std::uint8_t>(vertices, 0));
    };
    TileMesh mesh = mesh_of();
    std::vector<Collapse> edges;
    const TopologyChanges changes = collapse(mesh, settings, 4, &edges);
    check_faces(mesh);
    if (!settings.keep_pieces && !settings.error) REQUIRE(mesh.live_faces() <= 4);
    if (settings.keep_pieces) REQUIRE(changes.pieces == 0);
    TileMesh again = mesh_of();
    const auto repeated = Decimation::make(again, {}, settings);
    for (const Collapse& edge : edges) repeated->repeat(edge);
    REQUIRE(live_triangles(mesh) == live_triangles(again));
    REQUIRE(repeated->changes().handles == changes.handles);
    REQUIRE(repeated->changes().holes == changes.holes);
    REQUIRE(repeated->changes().pieces == changes.pieces);
  }
}

TEST_CASE("locked vertices stay where the topology is free") {
  TileMesh ring = tile_of(torus(24, 12));
  std::vector<Point> positions;
  std::vector<std::uint8_t> locked;
  std::vector<FaceVertices> faces;
  for (VertexNumber v = 0; v < ring.vertex_count(); ++v) {
    positions.push_back(ring.position(v));
    locked.push_back(v % 5 == 0 ? closed_vertex : free_vertex);
  }
  for (FaceNumber f = 0; f < ring.face_count(); ++f) faces.push_back(ring.face(f));
  TileMesh mesh(positions, faces, locked);
  collapse(mesh, free_settings(), 4);
  check_faces(mesh);
  for (VertexNumber v = 0; v < mesh.vertex_count(); v += 5)
    REQUIRE(mesh.position(v) == positions[v]);
}

}  // namespace winnow
