// What is written as OBJ and OFF says the same mesh, to the last bit.
#include "support/encoding.hpp"
#include "write/formats.hpp"

#include <charconv>
#include <sstream>

#include <catch2/catch.hpp>

namespace winnow {

using namespace test;

namespace {

std::vector<std::vector<std::string>> lines_of(const std::string& file) {
  std::vector<std::vector<std::string>> lines;
  std::istringstream in(file);
  for (std::string line; std::getline(in, line);) {
    if (line.empty() || line[0] == '#') continue;
    std::istringstream words(line);
    auto& to = lines.emplace_back();
    for (std::string word; words >> word;) to.push_back(word);
  }
  return lines;
}

template <typename Number>
Number number(const std::string& word) {
  Number value{};
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
  REQUIRE(error == std::errc());
  REQUIRE(end == word.data() + word.size());
  return value;
}

// Words from `at` on as the three coordinates that `position` is written as.
void check_position(const std::vector<std::string>& words, std::size_t at,
                    const std::array<double, 3>& position, bool doubles) {
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const std::string& word = words.at(at + axis);
    CHECK((doubles ? number<double>(word) : static_cast<double>(number<float>(word))) ==
          position[axis]);
  }
}

void check_normal(const std::vector<std::string>& words, std::size_t at, const MeshVertex& vertex) {
  for (std::size_t axis = 0; axis < 3; ++axis)
    CHECK(number<float>(words.at(at + axis)) == vertex.normal[axis]);
}

void check_obj(const EncodedExample& mesh, const std::string& file) {
  std::size_t vertex = 0;
  std::size_t normal = 0;
  std::size_t face = 0;
  for (const auto& words : lines_of(file)) {
    REQUIRE(words.size() == 4);
    if (words[0] == "v") {
      check_position(words, 1, mesh.vertices.at(vertex++).position, mesh.shape.double_positions);
    } else if (words[0] == "vn") {
      check_normal(words, 1, mesh.vertices.at(normal++));
    } else {
      REQUIRE(words[0] == "f");
      for (std::size_t corner = 0; corner < 3; ++corner) {
        const std::string one = std::to_string(mesh.faces.at(face).vertex[corner] + 1);
        CHECK(words[1 + corner] == (mesh.shape.normals ? one + "//" + one : one));
      }
      ++face;
    }
  }
  CHECK(vertex == mesh.vertices.size());
  CHECK(normal == (mesh.shape.normals ? vertex : 0));
  CHECK(face == mesh.faces.size());
}

void check_off(const EncodedExample& mesh, const std::string& file) {
  const auto lines = lines_of(file);
  const std::size_t vertices = mesh.vertices.size();
  REQUIRE(lines.size() == 2 + vertices + mesh.faces.size());
  CHECK(lines[0] == std::vector<std::string>{mesh.shape.normals ? "NOFF" : "OFF"});
  CHECK(lines[1] ==
        std::vector<std::string>{std::to_string(vertices), std::to_string(mesh.faces.size()), "0"});
  for (std::size_t i = 0; i < vertices; ++i) {
    const auto& words = lines[2 + i];
    REQUIRE(words.size() == (mesh.shape.normals ? 6 : 3));
    check_position(words, 0, mesh.vertices[i].position, mesh.shape.double_positions);
    if (mesh.shape.normals) check_normal(words, 3, mesh.vertices[i]);
  }
  for (std::size_t i = 0; i < mesh.faces.size(); ++i) {
    const auto& v = mesh.faces[i].vertex;
    CHECK(lines[2 + vertices + i] == std::vector<std::string>{"3", std::to_string(v[0]),
                                                              std::to_string(v[1]),
                                                              std::to_string(v[2])});
  }
}

}  // namespace

TEST_CASE("a written OBJ and a written OFF say the mesh that they are of") {
  Random random(620);
  const auto obj = obj_output.make({});
  const auto off = off_output.make({});
  CHECK_FALSE(obj->needs_corners());
  CHECK_FALSE(off->needs_corners());
  for (const bool normals : {false, true}) {
    for (const bool doubles : {false, true}) {
      for (const std::size_t count : {1, 3, 300}) {
        CAPTURE(normals, doubles, count);
        const EncodedExample mesh =
            example_mesh(random, count, 2 * count, normals, doubles, {431000, 5412000, 300});
        check_obj(mesh, encoded(*obj, mesh, random));
        check_off(mesh, encoded(*off, mesh, random));
        CHECK(encoded(*obj, mesh, random) == encoded(*obj, mesh, random));
      }
    }
  }
}

TEST_CASE("indices of OBJ and OFF go beyond 32 bits") {
  const MeshFace face{{0, 4294967295, 1099511627775}};
  std::vector<std::byte> bytes;
  obj_output.make({})->faces({}, 0, {&face, 1}, {}, bytes);
  CHECK(text_of(bytes) == "f 1 4294967296 1099511627776\n");
  bytes.clear();
  off_output.make({})->faces({}, 0, {&face, 1}, {}, bytes);
  CHECK(text_of(bytes) == "3 0 4294967295 1099511627775\n");
}

}  // namespace winnow
