// No duplicate or degenerate face, no vertex without a face, one order for all: in every result.
#include "support/clustering.hpp"
#include "support/kernels.hpp"

#include <algorithm>
#include <map>
#include <set>

#include <catch2/catch.hpp>

namespace winnow {

using namespace test;

namespace {

using Cells = std::array<CellKey, 3>;

Cells sorted(Cells cells) {
  std::sort(cells.begin(), cells.end());
  return cells;
}

void check_clean(const PlainMesh& mesh, const std::vector<Triangle>& faces, const Grid& grid) {
  // What should be there, by the definition.
  std::set<Cells> right;
  std::set<CellKey> cells;
  std::set<CellKey> used;
  for (const Triangle& face : faces) {
    const Cells key{key_of(grid, face[0]), key_of(grid, face[1]), key_of(grid, face[2])};
    cells.insert(key.begin(), key.end());
    if (key[0] == key[1] || key[1] == key[2] || key[0] == key[2]) continue;
    right.insert(sorted(key));
    used.insert(key.begin(), key.end());
  }
  CHECK(mesh.cells == cells.size());

  REQUIRE(mesh.vertices.size() == used.size());
  auto next = used.begin();
  for (const IndexedVertex& vertex : mesh.vertices)
    REQUIRE(vertex.key == *next++);  // all that are used, in key order

  REQUIRE(mesh.faces.size() == right.size());
  std::set<std::uint32_t> referenced;
  auto face_key = right.begin();
  for (const auto& face : mesh.faces) {
    for (const std::uint32_t index : face) REQUIRE(index < mesh.vertices.size());
    referenced.insert(face.begin(), face.end());
    // All that should be there, in the order of their keys: so none twice and none degenerate.
    REQUIRE(sorted({mesh.vertices[face[0]].key, mesh.vertices[face[1]].key,
                    mesh.vertices[face[2]].key}) == *face_key++);
    REQUIRE(face[0] < std::min(face[1], face[2]));  // begins at its lowest vertex
  }
  CHECK(referenced.size() == mesh.vertices.size());
}

}  // namespace

TEST_CASE("a result has each face once, no degenerate one, and no vertex that no face uses") {
  Random random(470);
  for (const double cell : {0.6, 0.2, 0.07, 0.02}) {
    for (const auto& faces : {ball(60, 0.2), cube(30), soup(random, 5000, 0.1),
                              soup(random, 5000, 0.9), placed(ball(30), 1, {5e6, -5e6, 0})}) {
      for (const Placement placement : {Placement::mean, Placement::quadric}) {
        const ClusterSettings settings = settings_over(faces, cell, placement);
        CAPTURE(cell, faces.size(), static_cast<int>(placement));
        check_clean(cluster(faces, settings), faces, settings.grid);
      }
    }
  }
}

TEST_CASE("a face without area that joins three cells is kept: dropping it would open a hole") {
  const std::vector<Triangle> faces{{Point{0.5, 0.5, 0}, Point{1.5, 0.5, 0}, Point{2.5, 0.5, 0}}};
  const ClusterSettings settings = settings_over(faces, 1);
  const PlainMesh mesh = cluster(faces, settings);
  CHECK(mesh.faces.size() == 1);
  CHECK(mesh.counts.bad.total() == 0);
  for (const IndexedVertex& vertex : mesh.vertices)
    CHECK(vertex.normal == std::array<float, 3>{0, 0, 0});
}

TEST_CASE("corners that lie closer than the lattice tells are no repeated corner") {
  // Their positions differ: the face is good, and falls into at most two cells.
  const std::vector<Triangle> faces{
      {Point{0.5, 0.5, 0.5}, Point{0.5 + 1e-12, 0.5, 0.5}, Point{7, 7, 7}},
      {Point{0.5, 0.5, 0.5}, Point{0.5, 0.5, 0.5}, Point{7, 7, 7}},
      {Point{0, 0, 0}, Point{3, 0, 0}, Point{0, 3, 0}}};
  const PlainMesh mesh = cluster(faces, settings_over(faces, 1));
  CHECK(mesh.counts.bad.degenerate == 1);
  CHECK(mesh.cells == 4);
  CHECK(mesh.faces.size() == 1);
}

TEST_CASE("nothing in, nothing out") {
  const ClusterSettings settings{unit_grid(), Placement::quadric, true};
  const PlainMesh none = cluster({}, settings);
  CHECK(none.cells == 0);
  CHECK(none.vertices.empty());
  CHECK(none.faces.empty());
  // All in one cell: a cell, but no face and so no vertex.
  const PlainMesh one = cluster(placed(ball(20), 0.1, {5.5, 5.5, 5.5}), settings);
  CHECK(one.cells == 1);
  CHECK(one.vertices.empty());
  CHECK(one.faces.empty());
}

}  // namespace winnow
