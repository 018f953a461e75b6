// Packed views of a glTF that do not fit into the budget beside each other, and some that lie.
#include "support/gltf_file.hpp"
#include "support/reading.hpp"
#include "support/sources.hpp"

#include <cstdint>
#include <map>

#include <catch2/catch.hpp>
#include <meshoptimizer.h>

namespace winnow::test {

namespace {

constexpr std::size_t vertices = 60'000;

template <typename Number>
std::size_t packed(GltfBuilder& file, const std::vector<Number>& numbers, int component,
                   const std::string& type) {
  const std::size_t stride = numbers.size() / vertices * sizeof(Number);
  std::vector<unsigned char> bytes(meshopt_encodeVertexBufferBound(vertices, stride));
  bytes.resize(
      meshopt_encodeVertexBuffer(bytes.data(), bytes.size(), numbers.data(), vertices, stride));
  return file.add("accessors",
                  {{"bufferView", file.packed_view(bytes, "ATTRIBUTES", vertices, stride)},
                   {"componentType", component},
                   {"normalized", component != 5126},
                   {"count", vertices},
                   {"type", type}});
}

// Triangles one after the other, with normals and colours in views of their own.
GltfBuilder packed_triangles() {
  GltfBuilder file;
  std::vector<float> xyz;
  std::vector<float> normals;
  std::vector<std::uint8_t> colors;
  for (std::uint32_t i = 0; i < vertices; ++i) {
    const auto x = static_cast<float>(i);
    xyz.insert(xyz.end(), {x, static_cast<float>(i % 3), static_cast<float>(i % 2)});
    normals.insert(normals.end(), {0, x / vertices, 1});
    for (const std::uint32_t shift : {0U, 5U, 8U, 11U})
      colors.push_back(static_cast<std::uint8_t>(i >> shift));
  }
  const std::size_t positions = packed(file, xyz, 5126, "VEC3");
  const std::size_t normal = packed(file, normals, 5126, "VEC3");
  const std::size_t color = packed(file, colors, 5121, "VEC4");
  file.mesh(Json::array(
      {{{"attributes", {{"POSITION", positions}, {"NORMAL", normal}, {"COLOR_0", color}}}}}));
  return file;
}

}  // namespace

TEST_CASE("packed views of a glTF that fit into the budget only one by one are read in turn") {
  const std::string glb = packed_triangles().glb();
  const auto read = [&](std::uint64_t memory) {
    return carried_by(std::make_unique<MemorySource>(glb), memory, std::uint64_t{64} << 10).numbers;
  };
  const std::vector<double> want = read(std::uint64_t{64} << 20);
  REQUIRE(want.size() == 7 * vertices);
  CHECK(want[vertices + 30'000] == 0.5);
  CHECK(want[3 * vertices + 300] == 300 % 256);
  // All three take 28 bytes a vertex, and what they are packed to.
  const std::uint64_t unpacked = 28 * vertices;
  std::map<bool, int> done;  // by whether they fit together
  for (std::uint64_t memory = 3 * unpacked; memory > unpacked / 2; memory -= unpacked / 8) {
    CAPTURE(memory);
    try {
      CHECK(read(memory) == want);
      ++done[memory > unpacked];
    } catch (const Error& error) {
      CHECK(error.kind() == ErrorKind::resources);
      CHECK(memory <= unpacked);
    }
  }
  CHECK(done[true] > 0);
  CHECK(done[false] > 0);
}

TEST_CASE("a packed view of a glTF that its bytes cannot hold takes no memory") {
  const auto refused = [](const Json& change) {
    GltfBuilder file = packed_triangles();
    Json& view = file.json["bufferViews"][2];
    view["extensions"]["EXT_meshopt_compression"].update(change);
    const std::size_t stride = view["extensions"]["EXT_meshopt_compression"]["byteStride"];
    view["byteLength"] =
        view["extensions"]["EXT_meshopt_compression"]["count"].get<std::size_t>() * stride;
    const std::string glb = file.glb();
    return error_of([&] { carried_by(std::make_unique<MemorySource>(glb)); });
  };
  for (const Json& change :
       {Json{{"count", 50'000'000}}, Json{{"byteStride", 12}, {"filter", "OCTAHEDRAL"}},
        Json{{"mode", "INDICES"}, {"filter", "EXPONENTIAL"}}}) {
    CAPTURE(change.dump());
    const Error error = refused(change);
    CHECK(error.kind() == ErrorKind::bad_input);
    CHECK_THAT(error.what(), Catch::Contains("do not fit each other"));
  }
  CHECK_THAT(refused({{"filter", "QUATERNION"}}).what(),
             Catch::Contains("a filter that is not for that"));
}

}  // namespace winnow::test
