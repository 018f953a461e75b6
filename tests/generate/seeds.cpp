// Another seed is another surface of the same kind; the same seed is the same surface.
#include "surface_mesh.hpp"

#include <algorithm>

#include <catch2/catch.hpp>

namespace winnow {

TEST_CASE("the seed changes the surface") {
  for (const Surface surface : all_surfaces) {
    CAPTURE(static_cast<int>(surface));
    CHECK(generated(generate_options(surface, 2000, 5)) ==
          generated(generate_options(surface, 2000, 5)));
    const SurfaceMesh one = mesh_of(generate_options(surface, 2000, 5));
    const SurfaceMesh other = mesh_of(generate_options(surface, 2000, 6));
    CHECK(one.points != other.points);
  }
}

TEST_CASE("surfaces are about two units across") {
  for (const Surface surface : all_surfaces) {
    for (std::uint32_t seed = 1; seed < 20; ++seed) {
      CAPTURE(static_cast<int>(surface), seed);
      double longest = 0;
      double farthest = 0;
      const SurfaceMesh mesh = mesh_of(generate_options(surface, 2000, seed));
      for (std::size_t axis = 0; axis < 3; ++axis) {
        const auto [low, high] =
            std::minmax_element(mesh.points.begin(), mesh.points.end(),
                                [&](const Point& a, const Point& b) { return a[axis] < b[axis]; });
        longest = std::max(longest, (*high)[axis] - (*low)[axis]);
        farthest = std::max({farthest, (*high)[axis], -(*low)[axis]});
      }
      CHECK(longest == Approx(2).epsilon(0.1));
      CHECK(farthest < 1.2);
    }
  }
}

}  // namespace winnow
