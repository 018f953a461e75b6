// Noise roughens a scan but never folds it: neighbouring faces do not turn their backs on each
// other.
#include "surface_mesh.hpp"

#include <algorithm>

#include <catch2/catch.hpp>

namespace winnow {

namespace {

// The least cosine between the normals of the two halves of a square, over squares all through the
// surface.
double sharpest(std::uint64_t faces, std::uint32_t seed) {
  const auto scan = make_surface(generate_options(Surface::scan, faces, seed));
  double least = 1;
  const std::uint64_t squares = scan->faces() / 2;
  const std::uint64_t stride = std::max<std::uint64_t>(1, squares / 20000);
  for (std::uint64_t square = 0; square < squares; square += stride) {
    std::array<Point, 2> normal{};
    for (std::size_t half = 0; half < 2; ++half) {
      const MeshFace face = scan->face(2 * square + half);
      normal[half] = doubled_area({scan->vertex(face.vertex[0]), scan->vertex(face.vertex[1]),
                                   scan->vertex(face.vertex[2])});
    }
    least = std::min(least, dot(normal[0], normal[1]) / (length(normal[0]) * length(normal[1])));
  }
  return least;
}

}  // namespace

TEST_CASE("a scan has no folds at any resolution") {
  for (const std::uint64_t faces : {50'000ULL, 1'000'000ULL, 20'000'000ULL, 1'000'000'000ULL}) {
    for (const std::uint32_t seed : {1U, 2U, 3U}) {
      CAPTURE(faces, seed);
      CHECK(sharpest(faces, seed) > -0.5);
    }
  }
}

}  // namespace winnow
