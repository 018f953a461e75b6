// Positions of a GLB as whole numbers, and the node that places them.
#include "support/encoding.hpp"
#include "support/glb_file.hpp"
#include "write/formats.hpp"
#include "write/glb_layout.hpp"

#include <cmath>

#include <catch2/catch.hpp>

namespace winnow {

using namespace test;

namespace {

double scale_of(const GlbFile& glb) {
  const auto scale = glb.json["nodes"][0]["scale"].get<Point>();
  CHECK((scale[0] == scale[1] && scale[0] == scale[2]));
  return scale[0];
}

Point placed(const GlbFile& glb, std::size_t vertex) {
  Point p{};
  for (std::size_t axis = 0; axis < 3; ++axis)
    p[axis] = glb.offset[axis] + scale_of(glb) * double{glb.positions[vertex][axis]};
  return p;
}

}  // namespace

TEST_CASE("a quantized position is no farther off than is said") {
  Random random(660);
  for (const unsigned bits : {1U, 8U, 14U, 16U}) {
    for (const double middle : {0.0, 431000.0, -5e6}) {
      for (const double half : {1e-3, 100.0}) {
        CAPTURE(bits, middle, half);
        EncodedExample mesh = example_mesh(random, 300, 500, true, true, {middle, 7, middle}, half);
        const auto encoder = glb_output.make({.quantize = bits});
        const double error = encoder->position_error(mesh.shape);
        const double steps = std::ldexp(1, static_cast<int>(bits)) - 1;
        CHECK(error == Approx(std::sqrt(3) / 2 * mesh.shape.box.longest_side() / steps));
        const GlbFile glb = glb_file(encoded(*encoder, mesh, random));
        double worst = 0;
        for (std::size_t i = 0; i < mesh.vertices.size(); ++i)
          worst = std::max(worst, length(placed(glb, i) - mesh.vertices[i].position));
        CHECK(worst <= error * (1 + 1e-6) + 1e-9);
        CHECK(worst > error / 4);
        // Half a step of 1/127 on each axis.
        for (std::size_t i = 0; i < mesh.vertices.size(); ++i) {
          const auto& n = mesh.vertices[i].normal;
          const Point one = unit({n[0], n[1], n[2]});
          for (std::size_t axis = 0; axis < 3; ++axis)
            CHECK(std::abs(double{glb.normals[i].at(axis)} - one.at(axis)) <= 0.5 / 127 + 1e-6);
        }
      }
    }
  }
}

TEST_CASE("a mesh of one place, and a flat one, are quantized, too") {
  Random random(661);
  EncodedExample point = example_mesh(random, 3, 1, false, false, {5, 6, 7}, 0);
  CHECK(placed(glb_file(encoded(*glb_output.make({.quantize = 9}), point, random)), 2) ==
        Point{5, 6, 7});
  EncodedExample flat = example_mesh(random, 40, 60, false, false);
  flat.shape.box = {};
  for (MeshVertex& vertex : flat.vertices) {
    vertex.position[2] = 0.25;
    flat.shape.box.add(vertex.position);
  }
  CHECK(placed(glb_file(encoded(*glb_output.make({.quantize = 9}), flat, random)), 2)[2] == 0.25);
}

TEST_CASE("only a GLB that is quantized moves positions") {
  Random random(662);
  const EncodedExample mesh = example_mesh(random, 300, 500, false, false);
  CHECK(glb_output.make({})->position_error(mesh.shape) == 0);
  const std::string plain = encoded(*glb_output.make({}), mesh, random);
  CHECK(plain.find("KHR_mesh_quantization") == std::string::npos);
  const std::string quantized = encoded(*glb_output.make({.quantize = 16}), mesh, random);
  CHECK(glb_file(quantized).json["extensionsRequired"] == nlohmann::json{"KHR_mesh_quantization"});
  CHECK(quantized.size() < plain.size());
}

TEST_CASE("a node turns a model whose z points up, to the bit") {
  Random random(663);
  for (const bool far : {false, true}) {
    const Point middle = far ? Point{431000, 5412000, 300} : Point{};
    const EncodedExample mesh = example_mesh(random, 60, 40, false, true, middle, 8);
    const std::string file = encoded(*glb_output.make({.up = UpAxis::z}), mesh, random);
    // Its vertices are those that it has without.
    const GlbFile glb = glb_file(file);
    CHECK(glb.positions == glb_file(encoded(*glb_output.make({}), mesh, random)).positions);
    const Point offset = glb_offset(mesh.shape);
    const std::vector<SeenFace> faces = faces_of(file);
    REQUIRE(faces.size() == mesh.faces.size());
    for (std::size_t i = 0; i < faces.size(); ++i) {
      if (faces[i].status != FaceStatus::good) continue;
      const auto& corners = mesh.faces[i].vertex;
      for (std::size_t k = 0; k < 3; ++k) {
        const Point& p = mesh.vertices[corners[k]].position;
        Point stored{};
        for (std::size_t axis = 0; axis < 3; ++axis)
          stored[axis] = offset[axis] + double{static_cast<float>(p[axis] - offset[axis])};
        CHECK(faces[i].corner[k] == Point{stored[0], stored[2], -stored[1]});
      }
    }
  }
}

}  // namespace winnow
