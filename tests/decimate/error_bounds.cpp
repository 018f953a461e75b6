// What an error bounds while edges are collapsed.
#include "decimate/decimation.hpp"
#include "decimate/tile_mesh.hpp"

#include <cmath>
#include <vector>

#include <catch2/catch.hpp>

namespace winnow {

namespace {

// A strip of n squares, as wide as `width` and as long as 1.
TileMesh strip(std::uint32_t n, double width) {
  std::vector<Point> positions;
  std::vector<FaceVertices> faces;
  for (std::uint32_t i = 0; i <= n; ++i) {
    const double x = static_cast<double>(i) / n;
    positions.push_back({x, 0, 0});
    positions.push_back({x, width, 0});
    if (i == 0) continue;
    const std::uint32_t at = 2 * i;
    faces.push_back({at - 2, at, at + 1});
    faces.push_back({at - 2, at + 1, at - 1});
  }
  const std::vector<std::uint8_t> locked(positions.size(), free_vertex);
  return {positions, faces, locked};
}

std::vector<Triangle> left(const TileMesh& mesh) {
  std::vector<Triangle> faces;
  for (FaceNumber f = 0; f < mesh.face_count(); ++f) {
    if (!mesh.removed(f)) faces.push_back(mesh.triangle(f));
  }
  return faces;
}

}  // namespace

TEST_CASE("a strip keeps its length within the bound of its boundary") {
  for (const double error : {0.001, 0.01, 0.05}) {
    for (const std::uint32_t n : {5, 50, 500}) {
      CAPTURE(error, n);
      TileMesh mesh = strip(n, 0.02);
      DecimationSettings settings;
      settings.single = false;
      settings.error = error;
      Decimation::make(mesh, {}, settings)->run({0}, [](const DoneCollapse&) {});
      const std::vector<Triangle> faces = left(mesh);
      REQUIRE(!faces.empty());
      CHECK(faces.size() <= 2);
      double low = 1;
      double high = 0;
      for (const Triangle& face : faces) {
        for (const Point& p : face) {
          low = std::min(low, p[0]);
          high = std::max(high, p[0]);
        }
      }
      CHECK(low <= 1.5 * error);
      CHECK(high >= 1 - 1.5 * error);
    }
  }
}

TEST_CASE("a lone face stays, whatever the error") {
  TileMesh mesh({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}}, {0, 0, 0});
  DecimationSettings settings;
  settings.error = 1000;
  Decimation::make(mesh, {}, settings)->run({0}, [](const DoneCollapse&) {});
  CHECK(mesh.live_faces() == 1);
}

}  // namespace winnow
