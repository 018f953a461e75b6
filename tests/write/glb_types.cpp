// Numbers of a GLB are of the smallest type that holds them.
#include "base/srgb.hpp"
#include "support/encoding.hpp"
#include "support/glb_file.hpp"
#include "write/formats.hpp"

#include <cmath>
#include <set>

#include <catch2/catch.hpp>

namespace winnow {

using namespace test;

namespace {

// A grey vertex of each of these numbers.
GlbFile grey(AttributeKind kind, NumberType type, const std::vector<double>& numbers) {
  EncodedExample mesh;
  mesh.shape.vertices = numbers.size();
  mesh.shape.faces = 1;
  for (const char* name : {"red", "green", "blue"})
    mesh.shape.attributes.push_back({name, type, kind});
  std::vector<double> values;
  for (const double number : numbers) values.insert(values.end(), 3, number);
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    MeshVertex& vertex = mesh.vertices.emplace_back();
    vertex.position = {static_cast<double>(i), 0, 0};
    vertex.attributes = std::span(values).subspan(3 * i, 3);
    mesh.shape.box.add(vertex.position);
  }
  mesh.faces.push_back({{0, 1, 2}});
  Random random(640);
  return glb_file(encoded(*glb_output.make({}), mesh, random));
}

std::vector<double> up_to(int last) {
  std::vector<double> numbers;
  for (int i = 0; i <= last; ++i) numbers.push_back(i);
  return numbers;
}

}  // namespace

TEST_CASE("all 256 numbers of a colour come back from the light in a GLB") {
  const GlbFile glb = grey(AttributeKind::color, NumberType::uint8, up_to(255));
  CHECK(glb.color_type == 5123);
  std::set<double> of_bytes;  // what a smaller type would leave
  for (std::size_t i = 0; i < 256; ++i) {
    const double light = glb.colors.at(3 * i);
    REQUIRE(std::nearbyint(255 * component_of_light(light)) == static_cast<double>(i));
    of_bytes.insert(std::nearbyint(255 * light));
  }
  CHECK(of_bytes.size() < 200);
}

TEST_CASE("light of 8 and 16 bits is written as it is") {
  for (const auto& [type, full, component] :
       {std::tuple(NumberType::uint8, 255, 5121U), std::tuple(NumberType::uint16, 65535, 5123U)}) {
    std::vector<double> colors = up_to(full);
    for (double& color : colors) color = full * component_of_light(color / full);
    const GlbFile glb = grey(AttributeKind::light, type, colors);
    CHECK(glb.color_type == component);
    for (std::size_t i = 0; i < colors.size(); ++i)
      REQUIRE(glb.colors.at(3 * i) == static_cast<float>(static_cast<double>(i) / full));
  }
}

TEST_CASE("colours of more than 8 bits are floats in a GLB") {
  CHECK(grey(AttributeKind::color, NumberType::uint16, up_to(9)).color_type == 5126);
  CHECK(grey(AttributeKind::color, NumberType::float32, {0, 0.25, 1}).color_type == 5126);
}

TEST_CASE("indices of a GLB have 16 bits where the largest number of those is not needed") {
  Random random(641);
  for (const std::size_t vertices : {3, 65'534, 65'535, 65'536}) {
    for (const std::size_t faces : {1, 2, 3}) {  // an odd number of them ends inside a word
      CAPTURE(vertices, faces);
      EncodedExample mesh = example_mesh(random, vertices, faces, false, false);
      mesh.faces[0].vertex[0] = vertices - 1;
      const GlbFile glb = glb_file(encoded(*glb_output.make({}), mesh, random));
      const std::size_t accessor = glb.json["meshes"][0]["primitives"][0]["indices"];
      CHECK(glb.json["accessors"][accessor]["componentType"] == (vertices <= 65'535 ? 5123 : 5125));
      for (std::size_t i = 0; i < faces; ++i) {
        for (std::size_t k = 0; k < 3; ++k) CHECK(glb.faces[i][k] == mesh.faces[i].vertex[k]);
      }
    }
  }
}

}  // namespace winnow
