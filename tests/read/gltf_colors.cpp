// Colours of a glTF: their types, and what is offered where primitives differ.
#include "support/gltf_file.hpp"
#include "support/reading.hpp"
#include "support/sources.hpp"

#include <cmath>
#include <cstdint>

#include <catch2/catch.hpp>

namespace winnow::test {

namespace {

using Names = std::vector<std::string>;
using Numbers = std::vector<double>;

const std::vector<Point> corner{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
const std::vector<std::uint8_t> bytes{0, 1, 2, 3, 128, 253, 254, 255, 100};
const Numbers of_bytes{0, 3, 254, 1, 128, 255, 2, 253, 100};

Carried read(const GltfBuilder& file) {
  const auto from = [&](const std::string& content, MemorySource::Kind kind) {
    return carried_by(std::make_unique<MemorySource>(content, kind));
  };
  Carried carried = from(file.glb(), MemorySource::Kind::file);
  CHECK(from(file.glb(), MemorySource::Kind::pipe).numbers.size() == carried.numbers.size());
  CHECK(from(file.gltf(), MemorySource::Kind::pipe).attributes == carried.attributes);
  return carried;
}

Json primitive(std::size_t positions, const Json& others) {
  Json attributes{{"POSITION", positions}};
  attributes.update(others);
  return {{"attributes", attributes}};
}

Carried colored(GltfBuilder& file, std::size_t colors) {
  file.mesh(Json::array({primitive(file.positions(corner), {{"COLOR_0", colors}})}));
  return read(file);
}

Names names(const std::string& type, bool alpha = false) {
  Names all;
  for (const char* name : {"red", "green", "blue", "alpha"})
    if (alpha || std::string(name) != "alpha") all.push_back(name + (" (" + type + ")"));
  return all;
}

}  // namespace

TEST_CASE("colours of a glTF have the numbers and the type of the file") {
  GltfBuilder of_8;
  const Carried small = colored(of_8, of_8.numbers(bytes, 5121, "VEC3", true, 4));
  CHECK(small.attributes == names("uchar"));
  CHECK(small.numbers == of_bytes);
  CHECK(small.facts.choice.carried[0].kind == AttributeKind::light);
  GltfBuilder of_16;
  const std::vector<std::uint16_t> words{0, 1, 65535, 9, 4000, 2, 3, 4, 5, 6, 7, 32768};
  const Carried wide = colored(of_16, of_16.numbers(words, 5123, "VEC4", true));
  CHECK(wide.attributes == names("ushort", true));
  CHECK(wide.numbers == Numbers{0, 4000, 5, 1, 2, 6, 65535, 3, 7, 9, 4, 32768});
  CHECK(wide.facts.choice.carried[3].kind == AttributeKind::value);
  GltfBuilder real;
  const Carried floats = colored(
      real,
      real.numbers<float>({0.1F, 2, -1, 1, 1, std::nanf(""), 0, 0, 0}, 5126, "VEC3", false, 24));
  CHECK(floats.attributes == names("float"));
  CHECK(floats.numbers[0] == 0.1F);
  CHECK(floats.numbers[3] == 2);
  CHECK(std::isnan(floats.numbers[7]));
}

TEST_CASE("colours of a glTF's primitives are of the widest type and have an alpha if any has") {
  GltfBuilder file;
  const std::size_t small = file.numbers(bytes, 5121, "VEC3", true, 4);
  const std::size_t wide =
      file.numbers<std::uint16_t>({1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12}, 5123, "VEC4", true);
  const std::size_t positions = file.positions(corner);
  // Vertices of the same positions are not mixed up.
  file.mesh(Json::array({primitive(positions, {{"COLOR_0", small}}),
                         primitive(positions, {{"COLOR_0", wide}}),
                         primitive(positions, {{"COLOR_0", small}})}));
  const Carried both = read(file);
  CHECK(both.attributes == names("ushort", true));
  CHECK(both.facts.vertices == 6);
  CHECK(Numbers(both.numbers.begin(), both.numbers.begin() + 9) ==
        Numbers{0, 771, 65278, 1, 5, 9, 0, 771, 65278});
  CHECK(Numbers(both.numbers.end() - 9, both.numbers.end()) ==
        Numbers{65535, 65535, 65535, 4, 8, 12, 65535, 65535, 65535});
  file.json["accessors"][wide] = {{"bufferView", file.view(std::string(36, '\0'))},
                                  {"componentType", 5126},
                                  {"count", 3},
                                  {"type", "VEC3"}};
  const Carried real = read(file);
  CHECK(real.attributes == names("float"));
  CHECK(real.numbers[1] == static_cast<float>(3 / 255.0));
}

TEST_CASE("what only some primitives of a glTF's scene have is told") {
  GltfBuilder file;
  const std::size_t colors = file.numbers(bytes, 5121, "VEC3", true, 4);
  const std::size_t normals = file.numbers<float>({0, 0, 1, 0, 0, 1, 0, 0, 1}, 5126, "VEC3");
  const std::size_t positions = file.positions(corner);
  file.mesh(Json::array({primitive(positions, {{"COLOR_0", colors}, {"NORMAL", normals}}),
                         primitive(positions, {{"NORMAL", normals}, {"COLOR_1", colors}})}));
  const std::size_t bare =
      file.mesh(Json::array({primitive(positions, {{"TEXCOORD_0", normals}})}));
  file.json["nodes"] = {{{"mesh", 0}}, {{"mesh", bare}}};
  file.json["scenes"] = {{{"nodes", {0}}}};
  const Carried some = read(file);
  CHECK(some.attributes == Names{"nx (float)", "ny (float)", "nz (float)"});
  CHECK(some.facts.offer.unread ==
        Names{"colours of some vertices", "more colours", "texture coordinates"});
  file.json["scenes"][0]["nodes"] = {0, 1};
  const Carried none = read(file);
  CHECK(none.attributes.empty());
  CHECK(none.facts.offer.unread.front() == "normals of some vertices");
  // With and without what is carried, vertices are the same.
  CHECK(none.facts.vertices == 6);
}

TEST_CASE("attributes of a glTF that its specification forbids are an error") {
  const auto refused = [](const Json& change) {
    GltfBuilder file;
    const std::size_t colors = file.numbers(bytes, 5121, "VEC3", true, 4);
    file.json["accessors"][colors].update(change);
    const Error error = error_of([&] { colored(file, colors); });
    CHECK(error.kind() == ErrorKind::bad_input);
    CHECK(std::string(error.what()).starts_with("'test'"));
    return std::string(error.what());
  };
  CHECK_THAT(refused({{"count", 2}}), Catch::Contains("'COLOR_0' has 2 elements for 3 positions"));
  CHECK_THAT(refused({{"componentType", 5125}}), Catch::Contains("`attributes` none"));
  CHECK_THAT(refused({{"type", "VEC2"}}), Catch::Contains("wrong type"));
  CHECK_THAT(refused({{"byteOffset", 1}}), Catch::Contains("behind the end"));
}

}  // namespace winnow::test
