// How near the count comes to what was asked for.
#include "surface_mesh.hpp"

#include <catch2/catch.hpp>

namespace winnow {

TEST_CASE("rows of columns meet any count that divides, exactly") {
  for (const Surface surface : {Surface::scan, Surface::terrain}) {
    for (const std::uint64_t faces :
         {8ULL, 10ULL, 12ULL, 1000ULL, 500'000ULL, 1'000'000ULL, 20'000'000ULL, 31'000'000ULL,
          1'000'000'000ULL, 10'000'000'000ULL, 1'000'000'000'000ULL}) {
      CAPTURE(static_cast<int>(surface), faces);
      CHECK(make_surface(generate_options(surface, faces))->faces() == faces);
    }
    // Odd, or twice a prime: no such grid.
    for (const std::uint64_t faces : {9ULL, 1001ULL, 2ULL * 500'009, 2ULL * 999'999'937}) {
      CAPTURE(static_cast<int>(surface), faces);
      const std::uint64_t made = make_surface(generate_options(surface, faces))->faces();
      CHECK(made + 20 >= faces);
      CHECK(made <= faces + 20);
    }
  }
}

TEST_CASE("a part comes within a thousandth, above its smallest count") {
  for (const std::uint32_t seed : {1U, 2U, 3U}) {
    for (const std::uint64_t faces :
         {5000ULL, 100'000ULL, 1'000'000ULL, 20'000'000ULL, 10'000'000'000ULL}) {
      CAPTURE(seed, faces);
      const auto made =
          static_cast<double>(make_surface(generate_options(Surface::part, faces, seed))->faces());
      CHECK(made == Approx(static_cast<double>(faces)).epsilon(0.001));
    }
  }
}

TEST_CASE("edges along and across the rows are about equally long") {
  for (const Surface surface : {Surface::scan, Surface::terrain}) {
    const SurfaceMesh mesh = mesh_of(generate_options(surface, 20000));
    double sum = 0;
    double area = 0;
    for (const MeshFace& face : mesh.faces) {
      const auto& [a, b, c] = face.vertex;
      const double edges = length(mesh.points[a] - mesh.points[b]) +
                           length(mesh.points[b] - mesh.points[c]) +
                           length(mesh.points[c] - mesh.points[a]);
      const double twice = length(doubled_area({mesh.points[a], mesh.points[b], mesh.points[c]}));
      // 1 for half a square, weighted by area: fans and throats are slim but small.
      sum += twice * (edges / std::sqrt(twice) / (2 + std::sqrt(2.0)));
      area += twice;
    }
    CHECK(sum / area < 1.25);
  }
}

}  // namespace winnow
