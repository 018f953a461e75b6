// Counts that 32 bits do not hold, probed without writing them.
#include <winnow/error.hpp>

#include "surface_mesh.hpp"

#include <algorithm>
#include <set>

#include <catch2/catch.hpp>

namespace winnow {

TEST_CASE("vertices and faces beyond 2^32 are where they belong") {
  for (const Surface surface : all_surfaces) {
    for (const std::uint64_t faces : {std::uint64_t{10'000'000'000}, std::uint64_t{1} << 44}) {
      CAPTURE(static_cast<int>(surface), faces);
      const auto huge = make_surface(generate_options(surface, faces));
      REQUIRE(huge->vertices() > std::uint64_t{1} << 32);
      const double edge = 4 / std::sqrt(static_cast<double>(faces));
      // All through, and the very last ones.
      for (std::uint64_t probe = 0; probe < 200; ++probe) {
        const std::uint64_t id =
            probe < 100 ? huge->faces() / 100 * probe : huge->faces() - (200 - probe);
        const MeshFace face = huge->face(id);
        const std::uint64_t highest = *std::max_element(face.vertex.begin(), face.vertex.end());
        REQUIRE(highest < huge->vertices());
        Triangle corners{};
        for (std::size_t n = 0; n < 3; ++n) corners[n] = huge->vertex(face.vertex[n]);
        CHECK(length(doubled_area(corners)) > 0);
        CHECK(length(corners[0] - corners[1]) < 5 * edge);
        CHECK(length(corners[0] - corners[2]) < 5 * edge);
      }
      std::set<std::uint64_t> last;
      for (std::uint64_t id = huge->faces() - 100; id < huge->faces(); ++id) {
        for (const std::uint64_t vertex : huge->face(id).vertex) last.insert(vertex);
      }
      CHECK(*last.rbegin() > std::uint64_t{1} << 32);
      // Neighbours in number are distinct points.
      const std::uint64_t end = huge->vertices() - 1;
      CHECK(huge->vertex(end) != huge->vertex(end - 1));
      CHECK(huge->vertex(end - 1) != huge->vertex(end - 2));
    }
  }
}

}  // namespace winnow
