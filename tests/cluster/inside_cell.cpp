// Every vertex of a result lies in its own cell, also as it is written.
#include "support/clustering.hpp"

#include <map>
#include <set>

#include <catch2/catch.hpp>

namespace winnow {

using namespace test;

namespace {

void check_inside(const PlainMesh& mesh, const ClusterSettings& settings) {
  REQUIRE(mesh.vertices.size() > 20);
  std::set<Point> positions;
  std::size_t wrong = 0;
  for (const IndexedVertex& vertex : mesh.vertices) {
    const std::array<std::uint32_t, 3> cell = morton_cell(vertex.key);
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const double x = vertex.position[axis];
      if (settings.grid.cell_of(x, axis) != cell[axis]) {
        if (wrong++ < 3)
          UNSCOPED_INFO("vertex at " << settings.grid.place(x, axis) << " of cell " << cell[axis]);
      }
      if (!settings.double_positions) REQUIRE(static_cast<double>(static_cast<float>(x)) == x);
    }
    positions.insert(vertex.position);
  }
  CHECK(wrong == 0);
  CHECK(positions.size() == mesh.vertices.size());  // no two share a position
}

void check_all(const std::vector<Triangle>& exact, double cell, const char* name) {
  for (const bool doubles : {true, false}) {
    // What is written as float was read as float.
    const std::vector<Triangle> faces = doubles ? exact : as_floats(exact);
    for (const Placement placement : {Placement::mean, Placement::quadric}) {
      for (const bool around : {true, false}) {
        ClusterSettings settings;
        settings.grid = around ? Grid::around(faces[0][0], cell) : Grid::over(box_of(faces), cell);
        settings.placement = placement;
        settings.double_positions = doubles;
        CAPTURE(name, cell, doubles, static_cast<int>(placement), around, exact[0][0]);
        check_inside(cluster(faces, settings), settings);
      }
    }
  }
}

}  // namespace

TEST_CASE("vertices lie inside of their cells") {
  Random random(440);
  for (const double cell : {0.1, 1.0 / 3, 0.25, 0.07}) {
    check_all(placed(ball(50), 1, {0, 0, 0}), cell, "ball");
    check_all(placed(cube(30), 2, {-1, -1, -1}), cell, "cube");
    check_all(placed(soup(random, 2000, 0.2), 1, {0, 0, 0}), cell, "soup");
  }
}

TEST_CASE("vertices on the walls of cells lie inside of one of them") {
  // Flat faces in the very planes that part the cells; zero among them, far from the lattice's
  // origin.
  for (const double cell : {0.1, 1.0 / 3, 0.25}) {
    check_all(placed(cube(30), 20 * cell, {-10 * cell, -10 * cell, -10 * cell}), cell,
              "aligned cube");
    check_all(placed(cube(30), 20 * cell, {-10 * cell, 0, -3 * cell + 1e-9}), cell,
              "cube a hair beside");
    check_all(placed(sheet(40), 10 * cell, {-5 * cell, -5 * cell, 0}), cell, "sheet at nothing");
    check_all(placed(sheet(40), 10 * cell, {-5 * cell, -5 * cell, -1e-12}), cell,
              "sheet below nothing");
  }
}

TEST_CASE(
    "georeferenced vertices lie inside of their cells, though a float steps by half a unit there",
    "[long]") {
  for (const Point& offset :
       {Point{5e6, 5e6, 100}, Point{-5e6, 5e6, 0}, Point{456'789.5, 5'432'100.25, 312}}) {
    for (const double cell : {0.3, 1.0, 17.0}) {
      check_all(placed(ball(50), 200 * cell, offset), cell * 20, "ball");
      check_all(placed(ball(30, 0.1), 200, offset), cell, "fine ball");
      check_all(placed(cube(30), 100, offset), cell, "cube");
    }
  }
}

TEST_CASE("a vertex is no farther than a cell's diagonal from every corner of its cluster") {
  const std::vector<Triangle> faces = ball(60, 0.1);
  for (const Placement placement : {Placement::mean, Placement::quadric}) {
    const double cell = 0.13;
    const ClusterSettings settings = settings_over(faces, cell, placement);
    const PlainMesh mesh = cluster(faces, settings);
    std::map<CellKey, Point> vertex;
    for (const IndexedVertex& v : mesh.vertices) vertex[v.key] = v.position;
    for (const Triangle& face : faces) {
      for (const Point& p : face) {
        std::array<std::uint32_t, 3> c{};
        for (std::size_t axis = 0; axis < 3; ++axis)
          c[axis] = static_cast<std::uint32_t>(settings.grid.cell_of(p[axis], axis));
        const auto found = vertex.find(morton_key(c[0], c[1], c[2]));
        if (found != vertex.end()) REQUIRE(length(p - found->second) <= cell * std::sqrt(3.0));
      }
    }
  }
}

}  // namespace winnow
