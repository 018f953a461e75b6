// Threads and memory never change a byte, and neither does the order in which a surface is asked.
#include "surface_mesh.hpp"

#include <algorithm>

#include <catch2/catch.hpp>

namespace winnow {

TEST_CASE("the same bytes with any number of threads and any budget", "[same_bytes]") {
  for (const Surface surface : all_surfaces) {
    for (const bool shuffle : {false, true}) {
      for (const Format format : {Format::ply, Format::stl}) {
        CAPTURE(static_cast<int>(surface), shuffle, static_cast<int>(format));
        GenerateOptions options = generate_options(surface, 150000);
        options.shuffle = shuffle;
        const std::string bytes = generated(options, format, 1);
        CHECK(generated(options, format, 2) == bytes);
        CHECK(generated(options, format, 7) == bytes);
        CHECK(generated(options, format, 2, std::uint64_t{6} << 20) == bytes);
      }
    }
  }
}

TEST_CASE("a vertex is the same alone and among others") {
  for (const Surface surface : all_surfaces) {
    CAPTURE(static_cast<int>(surface));
    const GenerateOptions options = generate_options(surface, 3000);
    const auto alone = make_surface(options);
    const SurfaceMesh mesh = mesh_of(options);
    bool same = true;
    for (std::size_t k = 0; k < mesh.points.size(); ++k)
      same = same && alone->vertex(k) == mesh.points[k];
    for (std::size_t k = 0; k < mesh.faces.size(); ++k) {
      same = same && alone->face(k).vertex == mesh.faces[k].vertex;
    }
    CHECK(same);

    std::vector<std::uint64_t> backwards(mesh.points.size());
    std::iota(backwards.rbegin(), backwards.rend(), std::uint64_t{0});
    std::vector<Point> points(backwards.size());
    alone->positions(backwards, points);
    std::reverse(points.begin(), points.end());
    CHECK(points == mesh.points);
  }
}

}  // namespace winnow
