// Vertices and edges with very many faces: what is walked grows with the mesh, and not with its
// square.
#include "decimate/decimation.hpp"
#include "decimate/tile_mesh.hpp"
#include "support/tile_meshes.hpp"

#include <cmath>
#include <string>
#include <vector>

#include <catch2/catch.hpp>

namespace winnow {

namespace {

struct Shape {
  std::vector<Point> positions;
  std::vector<FaceVertices> faces;
};

void add_circle(Shape& shape, std::uint32_t n, double z) {
  for (std::uint32_t i = 0; i < n; ++i) {
    const double angle = 6.283185307179586 * i / n;
    shape.positions.push_back({std::cos(angle), std::sin(angle), z});
  }
}

Shape fan(std::uint32_t n) {
  Shape shape{{{0, 0, 0}}, {}};
  add_circle(shape, n, 0);
  for (std::uint32_t i = 0; i < n; ++i) shape.faces.push_back({0, 1 + i, 1 + (i + 1) % n});
  return shape;
}

Shape bipyramid(std::uint32_t n) {
  Shape shape = fan(n);
  shape.positions[0] = {0, 0, 1};
  shape.positions.push_back({0, 0, -1});
  for (std::uint32_t i = 0; i < n; ++i) shape.faces.push_back({n + 1, 1 + (i + 1) % n, 1 + i});
  return shape;
}

Shape book(std::uint32_t n) {
  Shape shape{{{0, 0, -1}, {0, 0, 1}}, {}};
  add_circle(shape, n, 0);
  for (std::uint32_t i = 0; i < n; ++i) shape.faces.push_back({0, 1, 2 + i});
  return shape;
}

// Every pair of some vertices has an edge.
Shape crowd(std::uint32_t n) {
  constexpr std::uint32_t vertices = 100;
  Shape shape;
  add_circle(shape, vertices, 0);
  for (std::uint32_t i = 0; i < n; ++i) {
    const std::uint32_t a = i % vertices;
    const std::uint32_t b = (a + 1 + i / vertices % 49) % vertices;
    const std::uint32_t c = (b + 1 + i / (vertices * 49) % 49) % vertices;
    if (c != a) shape.faces.push_back({a, b, c});
  }
  return shape;
}

double steps_a_face(const Shape& shape, Refine cost, std::uint64_t faces) {
  TileMesh mesh(shape.positions, shape.faces, std::vector<std::uint8_t>(shape.positions.size(), 0));
  DecimationSettings settings;
  settings.cost = cost;
  settings.single = false;
  Decimation::make(mesh, {}, settings)->run({faces}, [](const DoneCollapse&) {});
  return static_cast<double>(mesh.steps()) / static_cast<double>(shape.faces.size());
}

}  // namespace

TEST_CASE("however many faces meet, what is walked grows with their number") {
  const Refine cost = GENERATE(from_range(test::costs()));
  const std::vector<std::pair<std::string, Shape (*)(std::uint32_t)>> shapes{
      {"fan", fan}, {"bipyramid", bipyramid}, {"book", book}, {"crowd", crowd}};
  for (const auto& [name, make] : shapes) {
    CAPTURE(name, cost);
    const double small = steps_a_face(make(2000), cost, 100);
    const double large = steps_a_face(make(40'000), cost, 100);
    // Twenty times as many: n log n allows for 1.4 times as much a face.
    CHECK(large < 2 * small + 50);
    CHECK(large < 400);
  }
}

TEST_CASE("a fan of any size becomes a fan of few faces, as round as they can be") {
  const Refine cost = GENERATE(from_range(test::costs()));
  for (const std::uint32_t n : {50, 500, 5000}) {
    CAPTURE(cost, n);
    const Shape shape = fan(n);
    TileMesh mesh(shape.positions, shape.faces,
                  std::vector<std::uint8_t>(shape.positions.size(), 0));
    DecimationSettings settings;
    settings.cost = cost;
    settings.single = false;
    Decimation::make(mesh, {}, settings)->run({20}, [](const DoneCollapse&) {});
    CHECK(mesh.live_faces() == 20);
    double area = 0;
    for (FaceNumber f = 0; f < mesh.face_count(); ++f) {
      if (!mesh.removed(f)) area += length(doubled_area(mesh.triangle(f))) / 2;
    }
    CHECK(area == Approx(3.14159).epsilon(0.02));
  }
}

TEST_CASE("a hub stays where it is, and its neighbours can go into it") {
  const Shape shape = fan(1000);
  TileMesh mesh(shape.positions, shape.faces, std::vector<std::uint8_t>(shape.positions.size(), 0));
  CHECK(mesh.hub(0));
  CHECK(mesh.owned_edges(0).empty());
  Decimation::make(mesh, {}, {})->run({200}, [&](const DoneCollapse& done) {
    CHECK(done.edge.removed != 0);
    if (done.edge.kept == 0) CHECK(done.edge.position == Point{0, 0, 0});
  });
  CHECK(mesh.live_faces() == 200);
}

TEST_CASE("neighbours go into a hub that is fixed, though its faces elsewhere are not known") {
  DecimationSettings settings;
  settings.cost = GENERATE(from_range(test::costs()));
  const Shape shape = book(10);
  std::vector<std::uint8_t> locked(shape.positions.size(), free_vertex);
  locked[0] = locked[1] = fixed_hub;
  TileMesh mesh(shape.positions, shape.faces, locked);
  Decimation::make(mesh, {}, settings)->run({3}, [&](const DoneCollapse& done) {
    CHECK(done.edge.removed > 1);
  });
  CHECK(mesh.live_faces() == 3);
  CHECK(mesh.position(0) == Point{0, 0, -1});
}

}  // namespace winnow
