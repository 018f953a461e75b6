// The surfaces are the same on every machine, with every compiler and at every level of
// optimisation: benches of today and of next year run on the same input. Whoever changes a surface
// on purpose changes a number here.
#include "surface_mesh.hpp"

#include <bit>

#include <catch2/catch.hpp>

namespace winnow {

namespace {

// FNV-1a, of the bits of all positions and of all corners.
std::uint64_t fingerprint(const SurfaceMesh& mesh) {
  std::uint64_t hash = 0xcbf29ce484222325;
  const auto add = [&](std::uint64_t bits) { hash = (hash ^ bits) * 0x100000001b3; };
  for (const Point& point : mesh.points) {
    for (const double value : point) add(std::bit_cast<std::uint64_t>(value));
  }
  for (const MeshFace& face : mesh.faces) {
    for (const std::uint64_t vertex : face.vertex) add(vertex);
  }
  return hash;
}

}  // namespace

TEST_CASE("the surfaces have not changed") {
  CHECK(fingerprint(mesh_of(generate_options(Surface::scan, 20000))) == 9967521205201092557U);
  CHECK(fingerprint(mesh_of(generate_options(Surface::terrain, 20000))) == 14533094595104689501U);
  CHECK(fingerprint(mesh_of(generate_options(Surface::part, 20000))) == 434247684054853021U);
}

}  // namespace winnow
