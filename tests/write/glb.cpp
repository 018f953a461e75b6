// What is written as GLB is valid glTF 2.0 and keeps the precision of a mesh far from the origin.
#include <winnow/error.hpp>

#include "support/encoding.hpp"
#include "support/glb_file.hpp"
#include "write/formats.hpp"

#include <cmath>

#include <catch2/catch.hpp>

namespace winnow {

using namespace test;

TEST_CASE("a written GLB holds the mesh that it is of") {
  Random random(630);
  const auto encoder = glb_output.make({});
  for (const bool normals : {false, true}) {
    for (const std::size_t count : {1, 3, 1000}) {
      CAPTURE(normals, count);
      const EncodedExample mesh = example_mesh(random, count, 2 * count, normals, false);
      const std::string file = encoded(*encoder, mesh, random);
      CHECK(file == encoded(*encoder, mesh, random));
      const GlbFile glb = glb_file(file);
      CHECK(glb.offset == Point{});  // floats stay where they are, wherever that is
      REQUIRE(glb.positions.size() == count);
      REQUIRE(glb.normals.size() == (normals ? count : 0));
      REQUIRE(glb.faces.size() == 2 * count);
      for (std::size_t i = 0; i < count; ++i) {
        for (std::size_t axis = 0; axis < 3; ++axis) {
          CHECK(static_cast<double>(glb.positions[i][axis]) == mesh.vertices[i].position[axis]);
        }
        if (normals) {
          // Which are of any length here.
          const auto& given = mesh.vertices[i].normal;
          const Point one = unit({given[0], given[1], given[2]});
          for (std::size_t axis = 0; axis < 3; ++axis)
            CHECK(double{glb.normals[i].at(axis)} == Approx(one.at(axis)).margin(1e-6));
        }
      }
      for (std::size_t i = 0; i < mesh.faces.size(); ++i) {
        for (std::size_t k = 0; k < 3; ++k) CHECK(glb.faces[i][k] == mesh.faces[i].vertex[k]);
      }
    }
  }
}

TEST_CASE("a GLB far from the origin is as precise as one near it") {
  Random random(631);
  const auto encoder = glb_output.make({});
  for (const double half : {1e-3, 0.7, 100.0, 3000.0}) {
    for (const Point& middle : {Point{431000, 5412000, 300}, Point{-431000, 0, -5412000}}) {
      CAPTURE(half, middle[0]);
      const EncodedExample mesh = example_mesh(random, 200, 400, false, true, middle, half);
      const GlbFile glb = glb_file(encoded(*encoder, mesh, random));
      const double side = mesh.shape.box.longest_side();
      for (std::size_t axis = 0; axis < 3; ++axis) {
        const double low = mesh.shape.box.low[axis];
        const bool far = std::max(std::abs(low), std::abs(mesh.shape.box.high[axis])) > 2 * side;
        CHECK((glb.offset[axis] != 0) == far);
        // A multiple of a power of two: at and above one unit a whole number.
        if (side >= 1) CHECK(glb.offset[axis] == std::floor(glb.offset[axis]));
        if (far) CHECK(glb.offset[axis] <= low);
        if (far) CHECK(glb.offset[axis] > low - side);
        for (std::size_t i = 0; i < mesh.vertices.size(); ++i) {
          // Coordinates within twice the size: half a step of floats there.
          const double back = static_cast<double>(glb.positions[i][axis]) + glb.offset[axis];
          CHECK(std::abs(back - mesh.vertices[i].position[axis]) <= side * 0x1p-23 + 0x1p-30);
        }
      }
    }
  }
}

TEST_CASE("a GLB near the origin is not moved") {
  Random random(632);
  const EncodedExample mesh = example_mesh(random, 200, 400, false, true, {50, -20, 0}, 100);
  CHECK(glb_file(encoded(*glb_output.make({}), mesh, random)).offset == Point{});
}

TEST_CASE("a normal of no length, or of another, becomes one of one") {
  Random random(633);
  EncodedExample mesh = example_mesh(random, 3, 1, true, false);
  mesh.vertices[1].normal = {0, 0, 0};
  mesh.vertices[2].normal = {0, -5, 0};
  const GlbFile glb = glb_file(encoded(*glb_output.make({}), mesh, random));
  CHECK(glb.normals[1] == std::array{0.0F, 0.0F, 1.0F});
  CHECK(glb.normals[2] == std::array{0.0F, -1.0F, 0.0F});
}

TEST_CASE("a GLB beyond 4 GiB and coordinates beyond floats are refused") {
  const auto encoder = glb_output.make({});
  Box box;
  box.add(Point{0, 0, 0});
  box.add(Point{1, 1, 1});
  const auto refused = [&](std::uint64_t vertices, std::uint64_t faces) {
    return error_of([&] {
             (void)encoder->header({.vertices = vertices, .faces = faces, .box = box});
           }).kind() == ErrorKind::usage;
  };
  CHECK(encoder->header({.vertices = 119'000'000, .faces = 238'000'000, .box = box}).size() > 100);
  CHECK(refused(120'000'000, 240'000'000));
  CHECK(refused(0, 400'000'000));
  CHECK(refused(400'000'000, 0));
  CHECK(refused(UINT64_MAX / 3, UINT64_MAX / 5));
  box.add(Point{1e300, 0, 0});
  CHECK(refused(3, 1));
}

}  // namespace winnow
