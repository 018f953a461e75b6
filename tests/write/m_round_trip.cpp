// What is written as .m is read back as the same mesh, to the last bit.
#include "support/encoding.hpp"
#include "write/formats.hpp"

#include <cmath>

#include <catch2/catch.hpp>

namespace winnow {

using namespace test;

TEST_CASE("a written .m is the mesh that it is of") {
  Random random(650);
  for (const bool doubles : {false, true}) {
    for (const std::size_t count : {3, 1000}) {
      CAPTURE(doubles, count);
      const EncodedExample mesh =
          example_mesh(random, count, 2 * count, false, doubles, {431000, 0, -3});
      const std::string file = encoded(*m_output.make({}), mesh, random);
      CHECK(file.starts_with("Vertex 1 "));
      const std::vector<SeenFace> faces = faces_of(file);
      REQUIRE(faces.size() == mesh.faces.size());
      for (std::size_t i = 0; i < faces.size(); ++i) {
        for (std::size_t k = 0; k < 3; ++k) {
          const Point& written = mesh.vertices[mesh.faces[i].vertex[k]].position;
          if (faces[i].status == FaceStatus::good) CHECK(faces[i].corner[k] == written);
        }
      }
    }
  }
}

TEST_CASE("a .m counts its vertices and faces on from part to part") {
  std::vector<std::byte> bytes;
  MeshVertex vertex;
  vertex.position = {0.1, 2, -3e-7};
  m_output.make({})->vertices({.double_positions = true}, 6, std::vector{vertex, vertex}, bytes);
  m_output.make({})->faces({}, 41, std::vector{MeshFace{{0, 6, 7}}}, {}, bytes);
  CHECK(text_of(bytes) == "Vertex 7 0.1 2 -3e-07\nVertex 8 0.1 2 -3e-07\nFace 42 1 7 8\n");
}

TEST_CASE("a .m holds normals and colours in braces") {
  std::vector<Attribute> colors;
  for (const char* name : {"red", "green", "blue"})
    colors.push_back({name, NumberType::uint8, AttributeKind::color});
  std::array<double, 3> stored{255, 51, 0};
  MeshVertex vertex;
  vertex.position = {1, 2, 3};
  vertex.normal = {0, 0.6F, -0.8F};
  const auto line = [&](bool normals, bool colored) {
    MeshShape shape{.normals = normals};
    vertex.attributes = {};
    if (colored) {
      shape.attributes = colors;
      vertex.attributes = stored;
    }
    std::vector<std::byte> bytes;
    m_output.make({})->vertices(shape, 0, std::vector{vertex}, bytes);
    return text_of(bytes);
  };
  CHECK(line(false, false) == "Vertex 1 1 2 3\n");
  CHECK(line(true, false) == "Vertex 1 1 2 3 {normal=(0 0.6 -0.8)}\n");
  CHECK(line(false, true) == "Vertex 1 1 2 3 {rgb=(1 0.2 0)}\n");
  CHECK(line(true, true) == "Vertex 1 1 2 3 {normal=(0 0.6 -0.8) rgb=(1 0.2 0)}\n");
  // What a colour cannot be is clipped.
  stored = {300, -51, NAN};
  CHECK(line(false, true) == "Vertex 1 1 2 3 {rgb=(1 0 0)}\n");
}

}  // namespace winnow
