// glTF that is wrong, cut or hostile: one error, at once, and no memory for what is not there.
#include "support/gltf_file.hpp"
#include "support/job.hpp"
#include "support/reading.hpp"
#include "support/sanitized.hpp"
#include "support/sources.hpp"

#include <functional>

#include <catch2/catch.hpp>

namespace winnow {

using test::GltfBuilder;
using test::Json;

namespace {

// How many faces it has; nothing where it is refused.
std::optional<std::size_t> read(const std::string& content, bool pipe = false) {
  try {
    test::TestJob test({.memory = std::uint64_t{64} << 20});
    const auto kind = pipe ? test::MemorySource::Kind::pipe : test::MemorySource::Kind::file;
    return test::faces_of(test.job, std::make_unique<test::MemorySource>(content, kind),
                          {Format::automatic, Access::once, {std::uint64_t{8} << 20, 1024}})
        .size();
  } catch (const Error& error) {
    CHECK((error.kind() == ErrorKind::bad_input || error.kind() == ErrorKind::resources));
    CHECK(std::string(error.what()).find('\n') == std::string::npos);
    return {};
  }
}

}  // namespace

TEST_CASE("a GLB cut at every byte is an error") {
  const std::string file = test::gltf_of(test::unit_square).glb();
  REQUIRE(read(file) == 2);
  for (std::size_t length = 0; length < file.size(); ++length) {
    CAPTURE(length);
    for (const bool pipe : {false, true}) CHECK_FALSE(read(file.substr(0, length), pipe));
  }
  const std::string json = test::gltf_of(test::unit_square).gltf();
  for (std::size_t length = 0; length < json.size(); ++length)
    CHECK_FALSE(read(json.substr(0, length)));
}

TEST_CASE("counts, sizes and indices of a glTF that its file does not hold are refused") {
  const std::vector<Json> wrong{Json(1000),
                                Json(4294967295),
                                Json(4294967296),
                                Json(9007199254740991),
                                Json(18446744073709551615U),
                                Json(-1),
                                Json(1e300),
                                Json("x"),
                                Json(0.5),
                                Json::array()};
  const std::vector<std::string> places{"/accessors/0/count",
                                        "/accessors/1/count",
                                        "/accessors/0/bufferView",
                                        "/accessors/0/byteOffset",
                                        "/bufferViews/0/byteLength",
                                        "/bufferViews/0/byteOffset",
                                        "/bufferViews/0/buffer",
                                        "/bufferViews/0/byteStride",
                                        "/meshes/0/primitives/0/indices",
                                        "/meshes/0/primitives/0/attributes/POSITION",
                                        "/nodes/0/mesh",
                                        "/nodes/0/children/0",
                                        "/scenes/0/nodes/0",
                                        "/scene"};
  for (const std::string& place : places) {
    for (const Json& value : wrong) {
      GltfBuilder file = test::gltf_of(test::unit_square);
      file.json["nodes"] = {{{"mesh", 0}, {"children", {1}}}, {{"translation", {0, 0, 0}}}};
      file.json["scenes"] = {{{"nodes", {0}}}};
      file.json["scene"] = 0;
      REQUIRE(read(file.glb()) == 2);
      file.json[Json::json_pointer(place)] = value;
      const std::uint64_t peak = peak_resident_bytes();
      CAPTURE(place, value.dump());
      // A stride may be wider than the file only where a single element is read.
      CHECK_FALSE(read(file.glb()));
      if (!test::sanitized) CHECK(peak_resident_bytes() - peak < std::uint64_t{32} << 20);
    }
  }
  GltfBuilder zeros;
  zeros.add("accessors", {{"componentType", 5126}, {"count", 4000000000U}, {"type", "VEC3"}});
  zeros.mesh(Json::array({{{"attributes", {{"POSITION", 0}}}}}));
  CHECK_FALSE(read(zeros.glb()));
  zeros.json["accessors"][0]["count"] = 3;
  CHECK(read(zeros.glb()) == 1);
}

TEST_CASE("nodes of a glTF in a circle, or with two parents, are refused") {
  const auto with_nodes = [](const Json& nodes, const Json& roots) {
    GltfBuilder file = test::gltf_of(test::unit_square);
    file.json["nodes"] = nodes;
    file.json["scenes"] = {{{"nodes", roots}}};
    return read(file.glb());
  };
  CHECK_FALSE(with_nodes({{{"children", {0}}}}, {0}));
  CHECK_FALSE(with_nodes({{{"children", {1}}}, {{"children", {0}}}}, {0}));
  CHECK_FALSE(with_nodes({{{"children", {1, 1}}}, {{"mesh", 0}}}, {0}));
  CHECK_FALSE(with_nodes({{{"mesh", 0}}}, {0, 0}));
}

TEST_CASE("JSON of a glTF may be nested and long, but not beyond the budget") {
  const auto with = [](const std::string& extras) {
    std::string text = test::gltf_of(test::unit_square).gltf();
    text.insert(text.rfind('}'), ",\"extras\":" + extras);
    return read(text);
  };
  CHECK(with(std::string(100'000, '[') + std::string(100'000, ']')) == 2);
  CHECK_FALSE(with(std::string(100'000, '[')));
  const std::uint64_t peak = peak_resident_bytes();
  std::string many = "[";
  for (int i = 0; i < 2'000'000; ++i) many += "[],";
  CHECK_FALSE(with(many + "0]"));
  if (!test::sanitized) CHECK(peak_resident_bytes() - peak < std::uint64_t{64} << 20);
}

TEST_CASE("bytes of a glTF changed at random are an error or another mesh, nothing worse") {
  test::Random random(520);
  for (int round = 0; round < 1500; ++round) {
    GltfBuilder builder = test::gltf_of(test::unit_square, 5123);
    builder.json["nodes"] = {{{"mesh", 0}, {"rotation", {0, 0, 0, 1}}}};
    std::string file = random.chance(0.5) ? builder.glb() : builder.gltf();
    for (std::uint64_t changes = random.between(1, 5); changes > 0; --changes) {
      const std::size_t at = random.below(file.size());
      file.replace(at, 1,
                   random.one_of<std::string>(
                       {"9", "-", "{", "[", "\"", ",", "\xff", std::string(1, '\0'), "e", ""}));
    }
    CAPTURE(round, file);
    const auto faces = read(file);
    CHECK(faces.value_or(0) < 1000);
  }
}

}  // namespace winnow
