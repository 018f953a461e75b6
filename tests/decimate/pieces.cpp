// Pieces of the surface go as a whole, the least first, or stay where they are to be kept.
#include "support/surfaces.hpp"
#include "support/tile_meshes.hpp"

#include <algorithm>

#include <catch2/catch.hpp>

namespace winnow {

using namespace test;

namespace {

void append(std::vector<Triangle>& faces, const std::vector<Triangle>& more) {
  faces.insert(faces.end(), more.begin(), more.end());
}

// Balls in a row, each twice as large as the one before.
std::vector<Triangle> balls(std::size_t count) {
  std::vector<Triangle> faces;
  double size = 1;
  for (std::size_t i = 0; i < count; ++i, size *= 2)
    append(faces, placed(ball(6), size, {4 * size, 0, 0}));
  return faces;
}

struct Run {
  std::vector<DoneCollapse> log;
  TopologyChanges changes;
};

Run run(TileMesh& mesh, const DecimationSettings& settings, std::uint64_t faces) {
  Run out;
  const auto decimation = Decimation::make(mesh, {}, settings);
  decimation->run({faces}, [&](const DoneCollapse& done) { out.log.push_back(done); });
  out.changes = decimation->changes();
  return out;
}

DecimationSettings doubles(Refine cost = Refine::quadric) {
  DecimationSettings settings;
  settings.cost = cost;
  settings.single = false;
  return settings;
}

}  // namespace

TEST_CASE("the smallest pieces go first and the last one stays") {
  const Refine cost = GENERATE(from_range(test::costs()));
  CAPTURE(cost);
  for (const std::uint64_t left : {1, 2, 5}) {
    CAPTURE(left);
    TileMesh mesh = tile_of(balls(6));
    const Run out = run(mesh, doubles(cost), 4 * left);
    CHECK(mesh.live_faces() == 4 * left);
    // Large ones may be worth more than four faces.
    CHECK(out.changes.pieces >= 6 - left);
    CHECK(out.changes.pieces < 6);
    CHECK(out.changes.handles == 0);
    CHECK(out.changes.area > 0);
    // Those that are left are the large ones, far out.
    for (const Triangle& face : live_triangles(mesh)) CHECK(face[0][0] > 2.5 * std::exp2(6 - left));
    for (std::size_t i = 1; i < out.log.size(); ++i)
      REQUIRE(out.log[i].cost >= out.log[i - 1].cost);
  }
  TileMesh mesh = tile_of(balls(3));
  run(mesh, doubles(cost), 0);
  CHECK(mesh.live_faces() == 4);
}

TEST_CASE("pieces that are kept end at the fewest faces") {
  DecimationSettings settings = doubles();
  settings.keep_pieces = true;
  settings.free_topology = GENERATE(false, true);
  CAPTURE(settings.free_topology);
  TileMesh closed = tile_of(balls(4));
  CHECK(run(closed, settings, 0).changes.pieces == 0);
  CHECK(closed.live_faces() == 16);
  CHECK(edges_by_faces(closed) == std::map<unsigned, std::size_t>{{2, 24}});
  std::vector<Triangle> sheets = sheet(6);
  append(sheets, sheet(6, 1));
  TileMesh open = tile_of(sheets);
  CHECK(run(open, settings, 0).changes.pieces == 0);
  CHECK(open.live_faces() == 2);
}

TEST_CASE("boundary loops end at three edges") {
  // A tube without caps.
  std::vector<Triangle> faces;
  for (const Triangle& face : torus(12, 40)) {
    if (std::all_of(face.begin(), face.end(), [](const Point& p) { return p[1] > -1e-9; }))
      faces.push_back(face);
  }
  DecimationSettings settings = doubles();
  settings.keep_pieces = true;
  TileMesh mesh = tile_of(faces);
  run(mesh, settings, 0);
  CHECK(mesh.live_faces() == 6);
  CHECK(edges_by_faces(mesh) == std::map<unsigned, std::size_t>{{1, 6}, {2, 6}});
}

TEST_CASE("a handle goes with its piece alone") {
  std::vector<Triangle> faces = ball(10);
  append(faces, placed(torus(12, 8), 0.01, {3, 0, 0}));
  TileMesh mesh = tile_of(faces);
  const Run out = run(mesh, doubles(), 4);
  CHECK(mesh.live_faces() == 4);
  CHECK(out.changes.pieces == 1);
  CHECK(out.changes.handles == 1);
  TileMesh alone = tile_of(torus(12, 8));
  CHECK(run(alone, doubles(), 0).changes.pieces == 0);
  CHECK(alone.live_faces() >= 14);
}

TEST_CASE("within an error a piece goes if it was smaller in every direction") {
  for (const double size : {0.9, 1.1}) {
    CAPTURE(size);
    std::vector<Triangle> faces = placed(ball(10), 20, {});
    // As long as `size`, and thin.
    for (Triangle face : ball(8)) {
      for (Point& p : face) p = {100 + size / 2 * p[0], 0.05 * p[1], 0.05 * p[2]};
      faces.push_back(face);
    }
    TileMesh mesh = tile_of(faces);
    DecimationSettings settings = doubles();
    settings.error = 1;
    CHECK(run(mesh, settings, 0).changes.pieces == (size < 1 ? 1 : 0));
  }
}

TEST_CASE("a list of collapses with pieces can be repeated") {
  DecimationSettings settings = doubles();
  if (GENERATE(false, true)) settings.error = 3;
  std::vector<Triangle> faces = balls(5);
  append(faces, placed(torus(12, 8), 0.01, {3, 0, 0}));
  TileMesh mesh = tile_of(faces);
  const Run out = run(mesh, settings, 10);
  REQUIRE(out.changes.pieces > 0);
  TileMesh again = tile_of(faces);
  const auto repeated = Decimation::make(again, {}, settings);
  for (const DoneCollapse& done : out.log) repeated->repeat(done.edge);
  CHECK(live_triangles(mesh) == live_triangles(again));
  CHECK(repeated->changes().pieces == out.changes.pieces);
  CHECK(repeated->changes().area == out.changes.area);
  CHECK(repeated->changes().handles == out.changes.handles);
}

}  // namespace winnow
