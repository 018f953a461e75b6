// Every vertex and every face is in one tile, and no tile is too large.
#include "stitch/tiling.hpp"

#include "support/refining.hpp"

#include <algorithm>

#include <catch2/catch.hpp>

namespace winnow {

using namespace test;

namespace {

void check_tiles(const StoredMesh& mesh, std::uint64_t most) {
  CAPTURE(most);
  const PlainMesh lists = plain(mesh);
  const Tiling tiling(mesh, most);
  REQUIRE(tiling.tiles() > 0);
  CHECK(tiling.first_vertex(0) == 0);
  CHECK(tiling.first_face(0) == 0);
  CHECK(tiling.first_vertex(tiling.tiles()) == lists.vertices.size());
  CHECK(tiling.first_face(tiling.tiles()) == lists.faces.size());
  std::uint64_t small = 0;
  for (std::size_t t = 0; t < tiling.tiles(); ++t) {
    const std::uint64_t begin = tiling.first_vertex(t);
    const std::uint64_t end = tiling.first_vertex(t + 1);
    REQUIRE(begin < end);
    REQUIRE(tiling.tile_of(begin) == t);
    REQUIRE(tiling.tile_of(end - 1) == t);
    const std::uint64_t faces = tiling.first_face(t + 1) - tiling.first_face(t);
    for (std::uint64_t f = tiling.first_face(t); f < tiling.first_face(t + 1); ++f) {
      REQUIRE(lists.faces[f][0] >= begin);
      REQUIRE(lists.faces[f][0] < end);
    }
    if (lists.vertices[begin].key != lists.vertices[end - 1].key) {
      REQUIRE(end - begin <= most);
      REQUIRE(faces <= most);
    }
    // Vertices with one key are together.
    if (end < lists.vertices.size())
      REQUIRE(lists.vertices[end - 1].key != lists.vertices[end].key);
    small += faces < most / 8;
  }
  // Most tiles are worth having: neighbours are joined.
  CHECK((tiling.tiles() == 1 || small <= tiling.tiles() / 2));
}

}  // namespace

TEST_CASE("tiles hold every vertex and face once and are small enough") {
  TestJob test;
  for (const std::string& path : {whale(), mountains()}) {
    const StoredMesh mesh = welded(test.job, path);
    for (const std::uint64_t most : {50, 500, 7000, 1'000'000}) check_tiles(mesh, most);
    CHECK(Tiling(mesh, 1'000'000).tiles() == 1);
    CHECK(Tiling(mesh, 7000).tiles() >= mesh.face_count / 7000);
  }
}

TEST_CASE("tiles of vertices that share a key are as large as they have to be") {
  TestJob test;
  // A small cloud in a large box: all of it has one key.
  Random random(860);
  std::vector<Triangle> faces = placed(soup(random, 300, 0.5), 1e-9, {0, 0, 0});
  faces.push_back({Point{0, 0, 0}, {1000, 0, 0}, {0, 1000, 0}});
  check_tiles(welded(test.job, faces), 100);
}

}  // namespace winnow
