// Where in its cell a vertex goes.
#include "support/clustering.hpp"

#include <algorithm>

#include <catch2/catch.hpp>

namespace winnow {

using namespace test;

namespace {

// How far a point is from the surface of the unit cube.
double to_cube(const Point& p) {
  Point outside{};
  double inside = HUGE_VAL;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    outside[axis] = std::max({0.0, -p[axis], p[axis] - 1});
    inside = std::min({inside, std::abs(p[axis]), std::abs(p[axis] - 1)});
  }
  const double out = length(outside);
  return out > 0 ? out : inside;
}

// On how many of the cube's planes' cells the vertex's cell lies: 3 at a corner of the cube, 2 at
// an edge.
int planes_through(const Grid& grid, const IndexedVertex& vertex) {
  const std::array<std::uint32_t, 3> cell = morton_cell(vertex.key);
  int planes = 0;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    planes += cell[axis] == grid.cell_of(0, axis) || cell[axis] == grid.cell_of(1, axis) ? 1 : 0;
  }
  return planes;
}

struct Worst {
  double corner = 0, edge = 0, side = 0;  // distances from the cube, in cells
  int corners = 0, edges = 0;
};

Worst worst_of(const ClusterSettings& settings) {
  const PlainMesh mesh = cluster(cube(150), settings);
  Worst worst;
  for (const IndexedVertex& vertex : mesh.vertices) {
    double nearest = HUGE_VAL;  // to a corner of the cube
    for (int i = 0; i < 8; ++i)
      nearest = std::min(nearest, length(vertex.position -
                                         Point{i & 1 ? 1.0 : 0, i & 2 ? 1.0 : 0, i & 4 ? 1.0 : 0}));
    switch (planes_through(settings.grid, vertex)) {
      case 3:
        worst.corner = std::max(worst.corner, nearest / settings.grid.cell);
        ++worst.corners;
        break;
      case 2:
        worst.edge = std::max(worst.edge, to_cube(vertex.position) / settings.grid.cell);
        ++worst.edges;
        break;
      default:
        worst.side = std::max(worst.side, to_cube(vertex.position) / settings.grid.cell);
        break;
    }
  }
  return worst;
}

}  // namespace

TEST_CASE("quadric placement keeps corners and edges where the mean rounds them off") {
  // The cube's planes cut through their cells in the middle and off it.
  for (const Point& origin :
       {Point{-0.09, -0.09, -0.09}, Point{-0.05, -0.08, -0.13}, Point{-0.15, -0.02, -0.1}}) {
    Grid grid{origin, 0.19, 1 / 0.19};
    const Worst sharp = worst_of({grid, Placement::quadric, true});
    const Worst round = worst_of({grid, Placement::mean, true});
    CAPTURE(origin);
    CHECK(sharp.corners == 8);
    CHECK(sharp.edges > 40);
    // The pull towards the mean is felt where little of a plane lies in the cell.
    CHECK(sharp.corner < 0.06);
    CHECK(sharp.corner < round.corner / 4);
    CHECK(sharp.edge < 0.02);
    CHECK(sharp.side < 1e-5);
    CHECK(round.corner > 0.1);
    CHECK(round.edge > 0.05);
    CHECK(round.side < 1e-5);
  }
}

TEST_CASE("the mean is that of the corners, by their areas") {
  // Closed corners of cubes: two within one cell, and a large one with a corner there, which makes
  // the cell used.
  const Grid grid = {{0, 0, 0}, 10, 0.1};
  std::vector<Triangle> faces;
  const auto add_corner = [&](const Point& at, double leg) {
    const Point x = at + Point{leg, 0, 0}, y = at + Point{0, leg, 0}, z = at + Point{0, 0, leg};
    for (const Triangle& face :
         {Triangle{at, y, x}, Triangle{at, z, y}, Triangle{at, x, z}, Triangle{x, y, z}})
      faces.push_back(face);
  };
  add_corner({1, 1, 1}, 2);
  add_corner({5, 4, 3}, 3);
  add_corner({8, 8, 9}, 10);
  Point weighted{};
  double weights = 0;
  for (std::size_t i = 0; i < faces.size(); ++i) {
    const bool equilateral = i % 4 == 3;
    const double area = length(area_vector(faces[i]));
    for (std::size_t corner = 0; corner < 3; ++corner) {
      const Point& p = faces[i][corner];
      if (*std::max_element(p.begin(), p.end()) >= 10) continue;
      // Right-angled at the first corner: half of the area lies there, and a quarter at the others.
      const double weight = area * (equilateral ? 1.0 / 3 : corner == 0 ? 0.5 : 0.25);
      weighted = weighted + weight * p;
      weights += weight;
    }
  }
  const PlainMesh mesh = cluster(faces, {grid, Placement::mean, true});
  REQUIRE(mesh.vertices.size() == 4);
  for (std::size_t axis = 0; axis < 3; ++axis)
    CHECK(mesh.vertices[0].position[axis] == Approx(weighted[axis] / weights).epsilon(1e-5));
}

TEST_CASE("on a smooth surface both placements lie near it") {
  const std::vector<Triangle> faces = ball(200);
  for (const Placement placement : {Placement::mean, Placement::quadric}) {
    const double cell = 0.1;
    const PlainMesh mesh = cluster(faces, settings_over(faces, cell, placement));
    double worst = 0;
    for (const IndexedVertex& vertex : mesh.vertices)
      worst = std::max(worst, std::abs(length(vertex.position) - 1));
    CAPTURE(static_cast<int>(placement));
    // The sagitta of a chord as long as a cell's diagonal.
    CHECK(worst < cell * cell * 3 / 8);
  }
}

TEST_CASE("a boundary stays where it is when long faces come along") {
  std::vector<Triangle> cap;
  double rim = 1;
  for (const Triangle& face : ball(100)) {
    if (face[0][2] < 0.3) continue;
    cap.push_back(face);
    for (const Point& corner : face) rim = std::min(rim, corner[2]);
  }
  // Thirty cells a side, in every batch.
  const Triangle far{Point{5, 5, 5}, Point{8, 5, 5}, Point{5, 8, 5}};
  std::vector<Triangle> both;
  for (std::size_t i = 0; i < cap.size(); ++i) {
    if (i % 50 == 0) both.push_back(far);
    both.push_back(cap[i]);
  }
  const ClusterSettings settings = settings_over(both, 0.1, Placement::quadric);
  const PlainMesh alone = cluster(cap, settings);
  const PlainMesh beside = cluster(both, settings);
  REQUIRE(beside.vertices.size() == alone.vertices.size() + 3);
  double lowest = 1;
  for (std::size_t i = 0; i < alone.vertices.size(); ++i) {
    CHECK(beside.vertices[i].key == alone.vertices[i].key);
    CHECK(beside.vertices[i].position == alone.vertices[i].position);
    lowest = std::min(lowest, alone.vertices[i].position[2]);
  }
  CHECK(lowest == Approx(rim).margin(0.01));
}

TEST_CASE("a cell of faces without area is placed at the mean of its corners") {
  const std::vector<Triangle> faces{
      {Point{0.2, 0.5, 0.5}, Point{1.5, 0.5, 0.5}, Point{2.5, 0.5, 0.5}},
      {Point{0.4, 0.5, 0.5}, Point{1.5, 0.5, 0.5}, Point{2.5, 0.5, 0.5}}};
  for (const Placement placement : {Placement::mean, Placement::quadric}) {
    const PlainMesh mesh = cluster(faces, {{{0, 0, 0}, 1, 1}, placement, true});
    REQUIRE(mesh.vertices.size() == 3);
    CHECK(mesh.vertices[0].position[0] == Approx(0.3).epsilon(1e-5));
    CHECK(mesh.vertices[0].position[1] == Approx(0.5).epsilon(1e-5));
    CHECK(mesh.vertices[2].position[0] == Approx(2.5).epsilon(1e-5));
  }
}

}  // namespace winnow
