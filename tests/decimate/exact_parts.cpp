// What a CAD part has beyond its corners goes without a trace, at any angle.
#include "base/closest_point.hpp"
#include "decimate/decimation.hpp"
#include "generate/surface.hpp"
#include "support/random.hpp"
#include "support/tile_meshes.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include <catch2/catch.hpp>

namespace winnow {

namespace {

// Rounded to floats after it was turned about each axis.
TileMesh turned_part(std::uint64_t faces, const Point& angles) {
  GenerateOptions options;
  options.surface = Surface::part;
  options.faces = faces;
  const auto part = make_surface(options);
  std::vector<Point> positions;
  for (std::uint64_t v = 0; v < part->vertices(); ++v) {
    Point p = part->vertex(v);
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const double y = p[(axis + 1) % 3];
      const double z = p[(axis + 2) % 3];
      p[(axis + 1) % 3] = std::cos(angles[axis]) * y - std::sin(angles[axis]) * z;
      p[(axis + 2) % 3] = std::sin(angles[axis]) * y + std::cos(angles[axis]) * z;
    }
    for (double& x : p) x = nearest_float(x);
    positions.push_back(p);
  }
  std::vector<FaceVertices> corners;
  for (std::uint64_t f = 0; f < part->faces(); ++f) {
    const auto face = part->face(f).vertex;
    FaceVertices& vertices = corners.emplace_back();
    std::transform(face.begin(), face.end(), vertices.begin(),
                   [](std::uint64_t v) { return static_cast<VertexNumber>(v); });
  }
  const std::size_t vertices = positions.size();
  return {std::move(positions), std::move(corners), std::vector<std::uint8_t>(vertices, 0)};
}

double distance(const Point& p, const std::vector<Triangle>& faces) {
  double square = std::numeric_limits<double>::infinity();
  for (const Triangle& face : faces) {
    const Point apart = p - closest_point(p, face);
    square = std::min(square, dot(apart, apart));
  }
  return std::sqrt(square);
}

}  // namespace

TEST_CASE("a part is exact at any angle", "[long]") {
  const Refine cost = GENERATE(Refine::volume, Refine::importance);
  const auto angles = GENERATE(Point{0, 0, 0}, Point{0.5, 0, 0}, Point{0.3, 1.1, -0.7});
  CAPTURE(cost, angles);
  TileMesh mesh = turned_part(6000, angles);
  double size = 0;
  std::vector<Point> before;
  for (VertexNumber v = 0; v < mesh.vertex_count(); ++v) {
    before.push_back(mesh.position(v));
    for (const double x : before.back()) size = std::max(size, std::abs(x));
  }
  DecimationSettings settings;
  settings.cost = cost;
  Decimation::make(mesh, {}, settings)->run({600}, [](const DoneCollapse&) {});
  CHECK(mesh.live_faces() <= 600);
  const auto left = test::live_triangles(mesh);
  double farthest = 0;
  for (const Point& p : before) farthest = std::max(farthest, distance(p, left));
  CHECK(farthest <= 1e-6 * size);
}

}  // namespace winnow
