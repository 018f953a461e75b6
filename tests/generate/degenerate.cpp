// No face of any surface is degenerate, neither as computed nor after rounding to single precision.
#include "surface_mesh.hpp"

#include <algorithm>

#include <catch2/catch.hpp>

namespace winnow {

namespace {

Point rounded(const Point& point) {
  Point result{};
  for (std::size_t axis = 0; axis < 3; ++axis)
    result[axis] = static_cast<double>(static_cast<float>(point[axis]));
  return result;
}

bool has_area(const Point& a, const Point& b, const Point& c) {
  return length(doubled_area({rounded(a), rounded(b), rounded(c)})) > 0;
}

}  // namespace

TEST_CASE("every face has an area in single precision") {
  for (const Surface surface : all_surfaces) {
    for (const std::uint64_t faces : {1000U, 300'000U}) {
      CAPTURE(static_cast<int>(surface), faces);
      const SurfaceMesh mesh = mesh_of(generate_options(surface, faces));
      CHECK(std::all_of(mesh.faces.begin(), mesh.faces.end(), [&](const MeshFace& face) {
        const auto& [a, b, c] = face.vertex;
        return has_area(mesh.points[a], mesh.points[b], mesh.points[c]);
      }));
    }
  }
}

// At the poles of a scan its columns run together: the slimmest faces are there.
TEST_CASE("a billion faces keep their area, up to the poles") {
  for (const Surface surface : all_surfaces) {
    CAPTURE(static_cast<int>(surface));
    const auto huge = make_surface(generate_options(surface, 1'000'000'000));
    bool all = true;
    for (std::uint64_t probe = 0; probe < 3000; ++probe) {
      const std::uint64_t id = probe < 1000   ? probe * 100
                               : probe < 2000 ? huge->faces() - 1 - (probe - 1000) * 100
                                              : huge->faces() / 1000 * (probe - 2000);
      const MeshFace face = huge->face(id);
      all = all && has_area(huge->vertex(face.vertex[0]), huge->vertex(face.vertex[1]),
                            huge->vertex(face.vertex[2]));
    }
    CHECK(all);
  }
}

}  // namespace winnow
