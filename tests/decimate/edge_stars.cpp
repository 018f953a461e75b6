// The faces around an edge, and what comes of them: the same bits from the kernels of every
// instruction set, and what the formulas say.
#include "base/rounding.hpp"
#include "decimate/edge_star.hpp"
#include "support/runnable.hpp"
#include "support/surfaces.hpp"
#include "support/tile_meshes.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <memory>
#include <vector>

#include <catch2/catch.hpp>

namespace winnow {

using namespace test;

namespace {

// A third of the area, times n n'.
VertexPlanes planes_of(const Triangle& face) {
  VertexPlanes planes;
  const Point doubled = doubled_area(face);
  if (length(doubled) > 0) add(planes, unit(doubled), length(doubled) / 6);
  return planes;
}

void check_near(const VertexPlanes& found, const VertexPlanes& right, double scale) {
  CHECK(found.xx == Approx(right.xx).margin(1e-12 * scale));
  CHECK(found.xy == Approx(right.xy).margin(1e-12 * scale));
  CHECK(found.xz == Approx(right.xz).margin(1e-12 * scale));
  CHECK(found.yy == Approx(right.yy).margin(1e-12 * scale));
  CHECK(found.yz == Approx(right.yz).margin(1e-12 * scale));
  CHECK(found.zz == Approx(right.zz).margin(1e-12 * scale));
}

}  // namespace

TEST_CASE("kernels of all instruction sets agree about stars to the bit") {
  Random random(850);
  const auto kernels = runnable(WINNOW_KERNELS(star_kernel));
  const auto plane_kernels = runnable(WINNOW_KERNELS(plane_kernel));
  const auto distance_kernels = runnable(WINNOW_KERNELS(distance_kernel));
  for (int round = 0; round < 400; ++round) {
    const auto batch = std::make_unique<StarBatch>();
    const std::size_t count = random.between(1, StarBatch::capacity);
    const double scale = std::pow(10.0, random.real(-12, 12));
    for (std::size_t axis = 0; axis < 3; ++axis) {
      batch->to[axis] = scale * random.real(-1, 1);
      for (std::size_t i = 0; i < StarBatch::capacity; ++i) {
        batch->from[axis][i] = scale * random.real(-1, 1);
        batch->second[axis][i] = scale * random.real(-1, 1);
        // Some faces have no area, before or after.
        batch->third[axis][i] = i % 5 == 1   ? batch->second[axis][i]
                                : i % 5 == 3 ? batch->to[axis]
                                             : scale * random.real(-1, 1);
        batch->stays[i] = i % 4 != 0 ? 1 : 0;
      }
    }
    std::vector<StarBatch> results;
    for (const auto& [name, kernel] : kernels) {
      StarBatch& result = results.emplace_back(*batch);
      kernel(result, count, {0.3, rounding_of_float});
    }
    for (const StarBatch& result : results) {
      for (std::size_t k = 0; k < 6; ++k) {
        REQUIRE(std::memcmp(result.planes[k], results[0].planes[k], count * sizeof(double)) == 0);
        REQUIRE(std::memcmp(result.change[k], results[0].change[k], count * sizeof(double)) == 0);
      }
      REQUIRE(std::memcmp(result.turned, results[0].turned, count * sizeof(double)) == 0);
      REQUIRE(std::memcmp(result.opened, results[0].opened, count * sizeof(double)) == 0);
    }
    double points[2][3];
    for (auto& point : points) {
      for (double& x : point) x = scale * random.real(-1, 1);
    }
    std::array<std::array<double, 2 * star_kernel_lanes>, 3> squares{};
    for (std::size_t i = 0; i < kernels.size(); ++i) {
      StarBatch of_planes = *batch;
      plane_kernels[i].second(of_planes, count, {0.3, rounding_of_float});
      if (i == 0) results[0] = of_planes;
      for (std::size_t k = 0; k < 6; ++k)
        REQUIRE(std::memcmp(of_planes.planes[k], results[0].planes[k], count * sizeof(double)) ==
                0);
      double least[2][star_kernel_lanes];
      std::fill(&least[0][0], &least[0][0] + 2 * star_kernel_lanes, scale * scale);
      distance_kernels[i].second(*batch, count, points, least);
      std::memcpy(squares.at(i).data(), least, sizeof least);
      REQUIRE(squares.at(i) == squares[0]);
    }
  }
}

TEST_CASE("a star has every face of both ends once, and says what comes of it") {
  Random random(851);
  for (int round = 0; round < 200; ++round) {
    // Many faces around few vertices: more than one batch.
    const auto vertices = static_cast<VertexNumber>(random.between(4, 12));
    std::vector<Point> positions(vertices);
    for (Point& p : positions) p = {random.real(-1, 1), random.real(-1, 1), random.real(-1, 1)};
    TileMesh mesh(positions, random_mesh(random, vertices, random.between(4, 120)),
                  std::vector<std::uint8_t>(vertices, 0));
    const auto kept = static_cast<VertexNumber>(random.below(vertices));
    const auto removed = (kept + 1) % vertices;
    const Point to{random.real(-1, 1), random.real(-1, 1), random.real(-1, 1)};
    EdgeStar star(rounding_of_double);
    star.find(mesh, kept, removed);
    star.move(mesh, to, 0.5);
    std::vector<FaceNumber> expected, found;
    for (FaceNumber f = 0; f < mesh.face_count(); ++f) {
      if (!mesh.removed(f) && (has(mesh.face(f), kept) || has(mesh.face(f), removed)))
        expected.push_back(f);
    }
    for (std::size_t i = 0; i < star.faces().size(); ++i) {
      const StarFace& face = star.faces()[i];
      found.push_back(face.number);
      const FaceVertices corners = mesh.face(face.number);
      REQUIRE(face.stays == (has(corners, kept) != has(corners, removed)));
      const VertexNumber moving = i < star.of_kept().size() ? kept : removed;
      REQUIRE(lowest_first({moving, face.w, face.x}) == lowest_first(corners));
      const Triangle before{mesh.position(moving), mesh.position(face.w), mesh.position(face.x)};
      const Triangle after{to, before[1], before[2]};
      const VertexPlanes old_planes = planes_of(before);
      const VertexPlanes new_planes = face.stays ? planes_of(after) : VertexPlanes{};
      check_near(star.planes(i), new_planes, 1);
      VertexPlanes sum = star.change(i);
      add(sum, old_planes);
      check_near(sum, new_planes, 1);
      const double cosine = dot(unit(doubled_area(before)), unit(doubled_area(after)));
      if (std::abs(cosine - 0.5) > 1e-9) REQUIRE(star.turned(i) == (face.stays && cosine < 0.5));
    }
    std::sort(found.begin(), found.end());
    REQUIRE(found == expected);
  }
}

}  // namespace winnow
