// How much of a feature an edge of each class is: computed by hand.
#include "decimate/edge_feature.hpp"

#include <cmath>
#include <numbers>

#include <catch2/catch.hpp>

namespace winnow {

namespace {

EdgeFeature feature(std::vector<Point> positions, std::vector<FaceVertices> faces, VertexNumber a,
                    VertexNumber b) {
  const std::size_t count = positions.size();
  TileMesh mesh(std::move(positions), std::move(faces), std::vector<std::uint8_t>(count, 0));
  const EdgeFeature one = feature_of(mesh, mesh.places(), a, b);
  const EdgeFeature other = feature_of(mesh, mesh.places(), b, a);
  CHECK(one.kind == other.kind);
  CHECK(one.weight == Approx(other.weight));
  return one;
}

// Four triangles around the edge from 0 to 1, with wings at `angle` to each other, closed at both
// ends so that neither end is at a boundary.
EdgeFeature of_wedge(double angle) {
  const double c = std::cos(angle / 2);
  const double s = std::sin(angle / 2);
  const std::vector<Point> positions{{0, 0, 0}, {0, 0, 1}, {c, s, 0.5}, {c, -s, 0.5}};
  // A tetrahedron.
  return feature(positions, {{0, 1, 3}, {1, 0, 2}, {0, 3, 2}, {1, 2, 3}}, 0, 1);
}

}  // namespace

TEST_CASE("an edge of three faces is a feature of weight 1, of four of weight 2") {
  const std::vector<Point> positions{{0, 0, 0}, {0, 0, 1},  {1, 0, 0},
                                     {0, 1, 0}, {-1, 0, 0}, {0, -1, 0}};
  const EdgeFeature three = feature(positions, {{0, 1, 2}, {0, 1, 3}, {0, 1, 4}}, 0, 1);
  CHECK(three.kind == EdgeClass::complex);
  CHECK(three.weight == 1);
  const EdgeFeature four = feature(positions, {{0, 1, 2}, {0, 1, 3}, {0, 1, 4}, {0, 1, 5}}, 0, 1);
  CHECK(four.kind == EdgeClass::complex);
  CHECK(four.weight == 2);
}

TEST_CASE("a boundary edge weighs 0 along a straight boundary, 1 at a right angle") {
  // A strip: 0 - 1 - 2 - 3 below, 4 - 5 - 6 above.
  const std::vector<Point> positions{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {3, 0, 0},
                                     {0, 1, 0}, {1, 1, 0}, {2, 1, 0}, {3, 1, 0}};
  const std::vector<FaceVertices> faces{{0, 1, 5}, {0, 5, 4}, {1, 2, 6},
                                        {1, 6, 5}, {2, 3, 7}, {2, 7, 6}};
  const EdgeFeature straight = feature(positions, faces, 1, 2);
  CHECK(straight.kind == EdgeClass::boundary);
  CHECK(straight.weight == Approx(0).margin(1e-12));
  const EdgeFeature corner = feature(positions, faces, 0, 1);
  CHECK(corner.kind == EdgeClass::boundary);
  CHECK(corner.weight == Approx(1));
  // The whole boundary of a lone equilateral triangle turns by 60 degrees: 1 + 1/2.
  const EdgeFeature spike =
      feature({{0, 0, 0}, {1, 0, 0}, {0.5, std::sqrt(0.75), 0}}, {{0, 1, 2}}, 0, 1);
  CHECK(spike.weight == Approx(1.5));
}

TEST_CASE("an edge across a strip weighs a quarter for each boundary edge at its ends") {
  const std::vector<Point> positions{{0, 0, 0}, {1, 0, 0}, {2, 0, 0},
                                     {0, 1, 0}, {1, 1, 0}, {2, 1, 0}};
  const std::vector<FaceVertices> faces{{0, 1, 4}, {0, 4, 3}, {1, 2, 5}, {1, 5, 4}};
  const EdgeFeature across = feature(positions, faces, 1, 4);
  CHECK(across.kind == EdgeClass::boundary_incident);
  CHECK(across.weight == 1);
  // A fan around a middle: one end is at the boundary.
  const std::vector<Point> fan{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {-1, 0, 0}, {0, -1, 0}};
  const EdgeFeature spoke = feature(fan, {{0, 1, 2}, {0, 2, 3}, {0, 3, 4}, {0, 4, 1}}, 0, 1);
  CHECK(spoke.kind == EdgeClass::boundary_incident);
  CHECK(spoke.weight == 0.5);
}

TEST_CASE("an edge is sharp where its faces meet at less than 60 degrees") {
  constexpr double degree = std::numbers::pi / 180;
  for (const double angle : {10.0, 30.0, 59.0}) {
    const EdgeFeature sharp = of_wedge(angle * degree);
    CHECK(sharp.kind == EdgeClass::sharp);
    CHECK(sharp.weight == Approx(std::sin(angle * degree)));
  }
  for (const double angle : {61.0, 90.0, 150.0}) {
    const EdgeFeature interior = of_wedge(angle * degree);
    CHECK(interior.kind == EdgeClass::interior);
    CHECK(interior.weight == 0);
  }
}

}  // namespace winnow
