// Collapsing without a queue: how far it goes hangs on the limits, what it does up to there does
// not; and the surface stays what it is.
#include "support/surfaces.hpp"
#include "support/tile_meshes.hpp"

#include <limits>
#include <vector>

#include <catch2/catch.hpp>

namespace winnow {

namespace {

constexpr double no_limit = std::numeric_limits<double>::infinity();

struct SweepsRun {
  std::vector<DoneCollapse> log;
  TileMesh mesh;
};

SweepsRun run_sweeps(const std::vector<Triangle>& triangles, const CollapseLimits& limits) {
  SweepsRun run{{}, test::tile_of(triangles)};
  Decimation::make(run.mesh, {}, {})->run(limits, [&](const DoneCollapse& done) {
    run.log.push_back(done);
  });
  return run;
}

bool same(const DoneCollapse& a, const DoneCollapse& b) {
  return a.edge.kept == b.edge.kept && a.edge.removed == b.edge.removed &&
         a.edge.position == b.edge.position && a.cost == b.cost;
}

}  // namespace

TEST_CASE("what sweeps do up to a cost or a count does not hang on it") {
  const auto triangles = test::ball(30, 0.2);
  const SweepsRun all = run_sweeps(triangles, {0, no_limit, 0});
  for (std::size_t i = 1; i < all.log.size(); ++i) REQUIRE(all.log[i].cost >= all.log[i - 1].cost);
  const double cost = all.log[all.log.size() / 2].cost;
  const CollapseLimits limits =
      GENERATE_COPY(CollapseLimits{0, cost, 0}, CollapseLimits{700, no_limit, 0});
  const SweepsRun part = run_sweeps(triangles, limits);
  REQUIRE(part.log.size() < all.log.size());
  for (std::size_t i = 0; i < part.log.size(); ++i) REQUIRE(same(part.log[i], all.log[i]));
  CHECK((part.log.back().cost >= cost || part.mesh.live_faces() == 700));
}

TEST_CASE("the count is met after sweeps, and what is closed stays closed") {
  const std::uint64_t sweeps_to = GENERATE(0, 600, 1500);
  const SweepsRun run = run_sweeps(test::ball(30, 0.1), {500, no_limit, sweeps_to});
  CHECK(run.mesh.live_faces() == 500);
  const auto edges = test::edges_by_faces(run.mesh);
  CHECK(edges.size() == 1);
  CHECK(edges.at(2) == 750);
}

TEST_CASE("collapses are repeated alike where vertices know their faces and where not") {
  const auto triangles = test::ball(30, 0.2);
  const SweepsRun run = run_sweeps(triangles, {400, no_limit, 600});
  const TileMesh first = test::tile_of(triangles);
  std::vector<Point> positions;
  std::vector<FaceVertices> faces;
  for (VertexNumber v = 0; v < first.vertex_count(); ++v) positions.push_back(first.position(v));
  for (FaceNumber f = 0; f < first.face_count(); ++f) faces.push_back(first.face(f));
  const bool linked = GENERATE(true, false);
  TileMesh again(positions, faces, std::vector<std::uint8_t>(positions.size(), free_vertex),
                 linked);
  std::vector<Collapse> edges;
  for (const DoneCollapse& done : run.log) edges.push_back(done.edge);
  Decimation::make(again, {}, {})->repeat(edges);
  CHECK(again.live_faces() == 400);
  CHECK(test::live_triangles(again) == test::live_triangles(run.mesh));
}

}  // namespace winnow
