// What was collapsed is not forgotten: one of its points says how far it is from what is left.
#include "decimate/witness_points.hpp"

#include "base/closest_point.hpp"
#include "base/rounding.hpp"
#include "support/random.hpp"

#include <algorithm>
#include <limits>
#include <numbers>
#include <vector>

#include <catch2/catch.hpp>

namespace winnow {

namespace {

// A needle of `rings` rings on a wide disc: the tip is vertex 0, the rings follow downwards,
// `around` vertices each; the last is the disc's.
TileMesh needle(std::size_t rings, std::size_t around, double height) {
  std::vector<Point> positions{{0, 0, height}};
  for (std::size_t ring = 1; ring <= rings; ++ring) {
    const double z = height * (1 - static_cast<double>(ring) / static_cast<double>(rings));
    const double r = ring == rings ? 10 : 0.01;
    for (std::size_t i = 0; i < around; ++i) {
      const double angle =
          2 * std::numbers::pi * static_cast<double>(i) / static_cast<double>(around);
      positions.push_back({r * std::cos(angle), r * std::sin(angle), z});
    }
  }
  std::vector<FaceVertices> faces;
  const auto at = [&](std::size_t ring, std::size_t i) {
    return static_cast<VertexNumber>(1 + (ring - 1) * around + i % around);
  };
  for (std::size_t i = 0; i < around; ++i) {
    faces.push_back({0, at(1, i), at(1, i + 1)});
    for (std::size_t ring = 1; ring < rings; ++ring) {
      faces.push_back({at(ring, i), at(ring + 1, i), at(ring + 1, i + 1)});
      faces.push_back({at(ring, i), at(ring + 1, i + 1), at(ring, i + 1)});
    }
  }
  std::vector<std::uint8_t> locked(positions.size(), 0);
  return {std::move(positions), std::move(faces), std::move(locked)};
}

double fourth(double x) {
  return x * x * x * x;
}

}  // namespace

TEST_CASE("a vertex that leaves no gap costs nothing more") {
  std::vector<Point> positions{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {-1, 0, 0}, {0, -1, 0}};
  std::vector<FaceVertices> faces{{0, 1, 2}, {0, 2, 3}, {0, 3, 4}, {0, 4, 1}};
  const TileMesh mesh(positions, faces, std::vector<std::uint8_t>(5, 0));
  WitnessPoints points(mesh, rounding_of_double);
  EdgeStar star(rounding_of_double);
  star.find(mesh, 1, 0);
  star.move(mesh, {1, 0, 0}, -1);
  CHECK(points.cost({1, 0, {1, 0, 0}}, star, 1e-9, false) == 1e-9);
}

TEST_CASE("a needle worn down in steps costs as much as one cut off at once") {
  constexpr std::size_t rings = 5;
  constexpr std::size_t around = 6;
  TileMesh mesh = needle(rings, around, 4);
  WitnessPoints points(mesh, rounding_of_double);
  // All of each ring goes into the tip, which comes down to the ring's height. Of the top, 4 high,
  // the first fifth is gone, then the second.
  for (std::size_t ring = 1; ring <= 2; ++ring) {
    const double z = 4 * (1 - static_cast<double>(ring) / rings);
    double highest = 0;
    for (std::size_t i = 0; i < around; ++i) {
      const auto v = static_cast<VertexNumber>(1 + (ring - 1) * around + i);
      const Collapse edge{0, v, {0, 0, z}};
      EdgeStar star(rounding_of_double);
      star.find(mesh, edge.kept, edge.removed);
      star.move(mesh, edge.position, -1);
      highest = std::max(highest, points.cost(edge, star, 0, false));
      points.collapsing(edge);
      mesh.collapse(edge);
    }
    CHECK(highest == Approx(8 * fourth(4 - z)).epsilon(0.01));
  }
}

TEST_CASE("the cost is that of the farther of both points, and never below the given one") {
  test::Random random(5);
  for (int round = 0; round < 200; ++round) {
    TileMesh mesh = needle(3, 5, random.real(0, 3));
    WitnessPoints points(mesh, rounding_of_double);
    const auto kept = static_cast<VertexNumber>(1 + random.below(5));
    const auto removed = static_cast<VertexNumber>(random.below(2) == 0 ? 0 : kept + 5);
    const Collapse edge{
        kept, removed, {random.real(-1, 1), random.real(-1, 1), random.real(-1, 4)}};
    double farthest = 0;
    for (const VertexNumber end : {kept, removed}) {
      double nearest = std::numeric_limits<double>::infinity();
      for (FaceNumber f = 0; f < mesh.face_count(); ++f) {
        FaceVertices face = mesh.face(f);
        if (has(face, kept) == has(face, removed)) continue;
        Triangle corners = mesh.triangle(f);
        for (std::size_t i = 0; i < 3; ++i) {
          if (face[i] == kept || face[i] == removed) corners[i] = edge.position;
        }
        const Point& p = mesh.position(end);
        nearest = std::min(nearest, length(p - closest_point(p, corners)));
      }
      farthest = std::max(farthest, nearest);
    }
    const double right = 8 * fourth(farthest);
    EdgeStar star(rounding_of_double);
    star.find(mesh, kept, removed);
    star.move(mesh, edge.position, -1);
    CHECK(points.cost(edge, star, 0, false) == Approx(right));
    CHECK(points.cost(edge, star, 2 * right + 1, false) == 2 * right + 1);
    CHECK(points.cost(edge, star, right / 2, false) == Approx(right));
  }
}

}  // namespace winnow
