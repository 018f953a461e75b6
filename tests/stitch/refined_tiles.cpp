// Many small tiles: the count is met, the surface stays whole, and nothing but the tiles' size
// shows.
#include "support/files.hpp"
#include "support/program.hpp"
#include "support/refining.hpp"

#include <catch2/catch.hpp>

namespace winnow {

using namespace test;

namespace {

// What is sound about any result.
void check_sound(const PlainMesh& mesh) {
  const Defects defects = defects_of(mesh.faces);
  CHECK(defects.degenerate == 0);
  CHECK(defects.duplicates == 0);
  std::vector<bool> used(mesh.vertices.size(), false);
  for (const auto& face : mesh.faces) {
    CHECK_FALSE(face[0] > std::min(face[1], face[2]));
    for (const std::uint32_t v : face) used.at(v) = true;
  }
  CHECK(std::count(used.begin(), used.end(), false) == 0);
}

// Closed, every edge with two faces that pass it in either direction.
void check_closed(const PlainMesh& mesh) {
  const Defects defects = defects_of(mesh.faces);
  CHECK(defects.boundary_edges == 0);
  CHECK(defects.crowded == 0);
  CHECK(defects.discords == 0);
}

}  // namespace

TEST_CASE("tiles meet the count and leave a closed surface closed", "[long]") {
  const Directory directory;
  const std::string scan = directory.file("scan.ply");
  generate("scan", 60'000, scan);
  for (const std::string& path : {whale(), scan}) {
    for (const std::uint64_t tile_faces : {500, 5000}) {
      for (const std::uint64_t wanted : {30'000, 6001, 700}) {
        CAPTURE(path, tile_faces, wanted);
        const RefinedPlain out = refined(path, down_to(wanted, tile_faces));
        // A closed surface has an even number of faces.
        CHECK(out.mesh.faces.size() == wanted / 2 * 2);
        CHECK(out.report.tiles > 60'000 / tile_faces);
        CHECK(out.report.stopped_by == StoppedBy::count);
        // The fewer faces of a tile lie away from its borders, the more rounds it takes.
        CHECK(out.report.rounds >= 2);
        CHECK(out.report.rounds <= (tile_faces == 500 ? 10 : 4));
        check_sound(out.mesh);
        check_closed(out.mesh);
      }
    }
  }
}

TEST_CASE("neither threads nor memory change what tiles become", "[same_bytes]") {
  for (const std::string& path : {whale(), mountains()}) {
    for (const bool with_error : {false, true}) {
      RefineSettings settings = down_to(4001, 500);
      if (with_error)
        settings.decimation.error = 1e9;  // the cost that remembers: states pass between rounds
      const RefinedPlain one = refined(path, settings, {.threads = 1});
      CHECK(one.mesh.faces.size() <= 4001);
      CHECK(one.mesh.faces.size() >= 3999);
      const RefinedPlain more = refined(path, settings, {.threads = 4});
      CHECK(difference(one.mesh, more.mesh) == "");
      CHECK(more.report.rounds == one.report.rounds);
      CHECK(more.report.largest_error == one.report.largest_error);
      const RefinedPlain small =
          refined(path, settings, {}, RefineMemory{1, 1 << 14, 1 << 16, 1 << 17});
      CHECK(small.mesh.spilled > one.mesh.spilled);
      CHECK(difference(one.mesh, small.mesh) == "");
    }
  }
}

TEST_CASE("one tile takes one round, and several take more for their borders") {
  const RefinedPlain one = refined(whale(), down_to(10'000, 1'000'000));
  CHECK(one.report.tiles == 1);
  CHECK(one.report.rounds == 1);
  CHECK(one.report.collapses == (100'000 - 10'000) / 2);
  const RefinedPlain several = refined(whale(), down_to(10'000, 10'000));
  CHECK(several.report.tiles >= 10);
  // A third where the second's own borders freeze much of what is wanted.
  CHECK(several.report.rounds >= 2);
  CHECK(several.report.rounds <= 3);
  CHECK(several.mesh.faces.size() == 10'000);
}

TEST_CASE("a mesh that has no more faces than wanted stays as it is") {
  const RefinedPlain same = refined(whale(), down_to(100'000, 5000));
  CHECK(same.mesh.faces.size() == 100'000);
  CHECK(same.report.collapses == 0);
  CHECK(same.report.rounds == 1);
  CHECK(same.report.stopped_by == StoppedBy::count);
}

TEST_CASE("many tiles of a surface that can become no smaller stop") {
  // Tetrahedra everywhere: none can lose a face, unless it goes as a whole.
  Random random(880);
  std::vector<Triangle> faces;
  for (int i = 0; i < 1000; ++i) {
    const Point at{random.unit(), random.unit(), random.unit()};
    const std::array<Point, 4> corner{at, at + Point{0.02, 0, 0}, at + Point{0, 0.02, 0},
                                      at + Point{0, 0, 0.02}};
    for (const auto& [a, b, c] : {std::array{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}})
      faces.push_back({corner[a], corner[b], corner[c]});
  }
  RefineSettings settings = down_to(10, 300);
  for (const bool keep : {true, false}) {
    CAPTURE(keep);
    settings.decimation.keep_pieces = keep;
    TestJob test;
    const auto [left, report, reference] =
        refine(test.job, welded(test.job, faces), settings, divided(test.job));
    CHECK(left.face_count == (keep ? 4000 : 8));
    CHECK(report.stopped_by == (keep ? StoppedBy::pieces : StoppedBy::count));
    CHECK(report.blocked.pieces == (keep ? 4000 : 0));
    CHECK(report.changes.pieces == (keep ? 0 : 998));
    CHECK(report.changes.handles == 0);
    CHECK(report.rounds <= 3);
  }
}

}  // namespace winnow
