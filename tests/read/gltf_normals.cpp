// Normals of a glTF, in every form that it has for them, where nodes place them.
#include "support/gltf_file.hpp"
#include "support/reading.hpp"
#include "support/sources.hpp"
#include "support/text_meshes.hpp"

#include <array>
#include <cmath>
#include <cstdint>

#include <catch2/catch.hpp>
#include <meshoptimizer.h>

namespace winnow::test {

namespace {

const std::vector<Point> corner{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};

// A triangle with these normals; as the file has them, or where `nodes` place them.
std::vector<Point> normals_of(GltfBuilder& file, std::size_t normals, const Json& nodes = nullptr) {
  file.mesh(
      Json::array({{{"attributes", {{"POSITION", file.positions(corner)}, {"NORMAL", normals}}}}}));
  if (!nodes.is_null()) file.json["nodes"] = nodes;
  std::vector<Point> seen(3);
  for (const auto kind : {MemorySource::Kind::file, MemorySource::Kind::pipe}) {
    const Carried carried = carried_by(std::make_unique<MemorySource>(file.glb(), kind));
    REQUIRE(carried.attributes ==
            std::vector<std::string>{"nx (float)", "ny (float)", "nz (float)"});
    CHECK(carried.facts.choice.carried[0].kind == AttributeKind::normal);
    for (std::size_t v = 0; v < 3; ++v)
      seen[v] = {carried.numbers[v], carried.numbers[3 + v], carried.numbers[6 + v]};
  }
  return seen;
}

std::vector<Point> placed(const std::vector<float>& normals, const Json& node) {
  GltfBuilder file;
  const std::size_t accessor = file.numbers(normals, 5126, "VEC3");
  Json nodes = Json::array({node});
  nodes[0]["mesh"] = 0;
  return normals_of(file, accessor, nodes);
}

void check_near(const Point& seen, const Point& wanted, double margin = 1e-7) {
  for (std::size_t axis = 0; axis < 3; ++axis)
    CHECK(seen[axis] == Approx(wanted[axis]).margin(margin));
}

}  // namespace

TEST_CASE("normals of a glTF are what they are where nothing turns them") {
  const std::vector<float> numbers{0.6F, 0.8F, 0, 0, 0, 3, 0, 0, 0};
  const std::vector<Point> want{{0.6F, 0.8F, 0}, {0, 0, 3}, {0, 0, 0}};
  GltfBuilder file;
  CHECK(normals_of(file, file.numbers(numbers, 5126, "VEC3")) == want);
  CHECK(placed(numbers, {{"translation", {1e6, 2, 3}}}) == want);
  GltfBuilder strided;
  CHECK(normals_of(strided, strided.numbers(numbers, 5126, "VEC3", false, 20)) == want);
}

TEST_CASE("quantized normals of a glTF") {
  for (const bool said : {true, false}) {
    GltfBuilder bytes;
    const std::vector<std::int8_t> of_bytes{127, 0, 0, 0, -127, 0, 0, 0, -128};
    CHECK(normals_of(bytes, bytes.numbers(of_bytes, 5120, "VEC3", said, 4)) ==
          std::vector<Point>{{1, 0, 0}, {0, -1, 0}, {0, 0, -1}});
    GltfBuilder words;
    const std::vector<std::int16_t> of_words{32767, 0, 0, 0, -16384, 0, 0, 0, -32768};
    CHECK(normals_of(words, words.numbers(of_words, 5122, "VEC3", said, 8)) ==
          std::vector<Point>{{1, 0, 0}, {0, static_cast<float>(-16384.0 / 32767), 0}, {0, 0, -1}});
  }
}

TEST_CASE("normals of a glTF packed as octahedra") {
  const std::vector<float> directions{0.6F, 0.8F, 0, 0, 0, 0, -1, 0, -0.6F, 0, -0.8F, 0};
  for (const std::size_t stride : {std::size_t{4}, std::size_t{8}}) {
    std::vector<unsigned char> plain(3 * stride);
    meshopt_encodeFilterOct(plain.data(), 3, stride, stride == 4 ? 8 : 16, directions.data());
    std::vector<unsigned char> packed(meshopt_encodeVertexBufferBound(3, stride));
    packed.resize(
        meshopt_encodeVertexBuffer(packed.data(), packed.size(), plain.data(), 3, stride));
    GltfBuilder file;
    const std::size_t view = file.packed_view(packed, "ATTRIBUTES", 3, stride, "OCTAHEDRAL");
    const std::size_t accessor =
        file.add("accessors", {{"bufferView", view},
                               {"componentType", stride == 4 ? 5120 : 5122},
                               {"normalized", true},
                               {"count", 3},
                               {"type", "VEC3"}});
    const std::vector<Point> seen = normals_of(file, accessor);
    for (std::size_t v = 0; v < 3; ++v) {
      const Point want{directions[4 * v], directions[4 * v + 1], directions[4 * v + 2]};
      check_near(seen[v], want, stride == 4 ? 0.02 : 1e-4);
    }
  }
}

TEST_CASE("normals of a glTF changed by a sparse accessor") {
  GltfBuilder file;
  const std::size_t normals = file.numbers<float>({0, 0, 1, 0, 0, 1, 0, 0, 1}, 5126, "VEC3");
  std::string index;
  std::string value;
  put_number(index, std::uint16_t{1});
  for (const float x : {0.0F, 1.0F, 0.0F}) put_number(value, x);
  const std::size_t indices = file.view(index);
  const std::size_t values = file.view(value);
  file.json["accessors"][normals]["sparse"] = {
      {"count", 1},
      {"indices", {{"bufferView", indices}, {"componentType", 5123}}},
      {"values", {{"bufferView", values}}}};
  CHECK(normals_of(file, normals) == std::vector<Point>{{0, 0, 1}, {0, 1, 0}, {0, 0, 1}});
}

TEST_CASE("nodes take normals of a glTF along with the surface") {
  const double half = std::sqrt(0.5);
  const std::vector<float> x{1, 0, 0, 0, 1, 0, 0, 0, 0};
  const auto turned = placed(x, {{"rotation", {0, 0, half, half}}});
  check_near(turned[0], {0, 1, 0});
  check_near(turned[1], {-1, 0, 0});
  CHECK(turned[2] == Point{0, 0, 0});
  // Of a slope that becomes flatter; longer or shorter ones have the length 1.
  const auto stretched = placed({0.6F, 0.8F, 0, 3, 4, 0, 0, 0, 1e-20F}, {{"scale", {2, 1, 1}}});
  const double length = std::hypot(0.3, 0.8);
  check_near(stretched[0], {0.3 / length, 0.8 / length, 0});
  check_near(stretched[1], {0.3 / length, 0.8 / length, 0});
  check_near(stretched[2], {0, 0, 1});
  // Outside stays outside where the surface is mirrored, which swaps the first two corners, and
  // where the node is huge, tiny or flat.
  const auto mirrored = placed(x, {{"scale", {-1, 1, 1}}});
  check_near(mirrored[1], {-1, 0, 0});
  check_near(mirrored[0], {0, 1, 0});
  for (const double size : {1e-150, 1e-30, 1e30, 1e150}) {
    CAPTURE(size);
    check_near(placed(x, {{"scale", {size, size, size}}})[1], {0, 1, 0});
    check_near(placed(x, {{"scale", {-size, -size, -size}}})[0], {0, -1, 0});
  }
  check_near(placed({1, 0, 1, 0, 0, 1, 0, 0, -1}, {{"scale", {1, 1, 0}}})[0], {0, 0, 1});
}

TEST_CASE("normals of a glTF that are no numbers stay so") {
  const auto seen = placed({std::nanf(""), 0, 0, 0, INFINITY, 0, 0, 0, 1}, {{"scale", {2, 2, 2}}});
  CHECK(std::isnan(seen[0][0]));
  CHECK_FALSE(std::isfinite(seen[1][1]));
  CHECK(seen[2] == Point{0, 0, 1});
}

}  // namespace winnow::test
