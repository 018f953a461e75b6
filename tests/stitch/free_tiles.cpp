// Rings everywhere, in many tiles and across their borders: pieces, handles and holes go by one
// cost, whatever the threads and the memory.
#include "support/refining.hpp"
#include "support/surfaces.hpp"

#include <cmath>

#include <catch2/catch.hpp>

namespace winnow {

using namespace test;

namespace {

std::vector<Triangle> rings(std::size_t count) {
  Random random(1601);
  std::vector<Triangle> faces;
  for (std::size_t i = 0; i < count; ++i) {
    const double size = 0.01 * std::exp2(4 * random.unit());
    const Point at{random.unit(), random.unit(), random.unit()};
    // Some are open.
    const std::vector<Triangle> ring = placed(torus(12, 6), size, at);
    faces.insert(faces.end(), ring.begin(), ring.end() - (i % 3 == 0 ? 2 : 0));
  }
  return as_floats(faces);
}

RefinedPlain refined_rings(const std::vector<Triangle>& faces, const RefineSettings& settings,
                           unsigned threads, bool small) {
  TestJob test({.threads = threads});
  const RefineMemory memory =
      small ? RefineMemory{1, 1 << 14, 1 << 16, 1 << 17} : divided(test.job);
  const Refined refined = refine(test.job, welded(test.job, faces), settings, memory);
  return {plain(refined.mesh), refined.report};
}

}  // namespace

TEST_CASE("rings in many tiles go the same way with any threads and memory", "[same_bytes]") {
  const std::vector<Triangle> faces = rings(400);
  RefineSettings settings = down_to(500, 1000);
  settings.decimation.keep_pieces = GENERATE(false, true);
  settings.decimation.free_topology = GENERATE(false, true);
  settings.decimation.cost = GENERATE(Refine::quadric, Refine::volume);
  CAPTURE(static_cast<int>(settings.decimation.cost), settings.decimation.keep_pieces,
          settings.decimation.free_topology);
  const RefinedPlain one = refined_rings(faces, settings, 1, false);
  const TopologyChanges& lost = one.report.changes;
  CHECK(one.report.tiles > 10);
  CHECK((lost.pieces > 0) == !settings.decimation.keep_pieces);
  CHECK((lost.area > 0) == (lost.pieces > 0));
  const Defects defects = defects_of(one.mesh.faces);
  CHECK(defects.duplicates + defects.degenerate == 0);
  if (settings.decimation.free_topology) {
    CHECK(lost.handles > 0);
  } else {
    CHECK(defects.crowded == 0);
  }
  if (!settings.decimation.keep_pieces) {
    CHECK(one.mesh.faces.size() <= 500);
    CHECK(one.report.stopped_by == StoppedBy::count);
  } else {
    CHECK(one.mesh.faces.size() > 500);
    CHECK(one.report.stopped_by != StoppedBy::count);
  }
  for (const auto& [threads, small] : {std::pair{2U, false}, {7U, false}, {2U, true}}) {
    const RefinedPlain other = refined_rings(faces, settings, threads, small);
    CHECK(difference(one.mesh, other.mesh) == "");
    CHECK(other.report.changes.pieces == lost.pieces);
    CHECK(other.report.changes.area == lost.area);
    CHECK(other.report.changes.handles == lost.handles);
    CHECK(other.report.changes.holes == lost.holes);
    CHECK(other.report.rounds == one.report.rounds);
  }
}

TEST_CASE("vertices of a crowd are joined the same way with any threads and memory",
          "[same_bytes]") {
  Random random(3);
  std::vector<Point> points(600);
  for (Point& p : points) p = {random.unit(), random.unit(), random.unit()};
  std::vector<Triangle> faces;
  while (faces.size() < 60'000) {
    const Triangle face{points[random.below(600)], points[random.below(600)],
                        points[random.below(600)]};
    if (face[0] != face[1] && face[1] != face[2] && face[2] != face[0]) faces.push_back(face);
  }
  faces = as_floats(faces);
  RefineSettings settings = down_to(GENERATE(4, 100, 3000), 1000);
  settings.decimation.free_topology = true;
  const RefinedPlain one = refined_rings(faces, settings, 1, false);
  CHECK(one.mesh.faces.size() <= settings.faces);
  CHECK(one.mesh.faces.size() > settings.faces / 2);
  CHECK(one.report.joined > 500);
  CHECK(one.report.stopped_by == StoppedBy::count);
  const Defects defects = defects_of(one.mesh.faces);
  CHECK(defects.duplicates + defects.degenerate == 0);
  for (const auto& [threads, small] : {std::pair{7U, false}, {2U, true}})
    CHECK(difference(one.mesh, refined_rings(faces, settings, threads, small).mesh) == "");
  settings.decimation.keep_pieces = true;
  CHECK(refined_rings(faces, settings, 1, false).report.joined == 0);
}

}  // namespace winnow
