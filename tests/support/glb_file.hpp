// A GLB of one mesh, taken apart by the rules of the glTF 2.0 specification.
#pragma once

#include "base/vector.hpp"

#include <array>
#include <cstdint>
#include <cstring>
#include <string>
#include <vector>

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

namespace winnow::test {

struct GlbFile {
  nlohmann::json json;
  Point offset{};
  std::vector<std::array<float, 3>> positions, normals;
  std::vector<std::array<std::uint32_t, 3>> faces;
};

inline std::uint32_t number_at(const std::string& file, std::size_t at) {
  std::uint32_t number = 0;
  REQUIRE(at + sizeof number <= file.size());
  std::memcpy(&number, file.data() + at, sizeof number);
  return number;
}

// The elements of an accessor, which must lie within their view and buffer, as T.
template <typename T>
std::vector<T> elements(const nlohmann::json& json, const std::string& binary, std::size_t accessor,
                        unsigned component) {
  const auto& from = json["accessors"].at(accessor);
  const auto& view = json["bufferViews"].at(from["bufferView"].get<std::size_t>());
  CHECK(from["componentType"] == component);
  const std::size_t stride = view.value("byteStride", sizeof(T));
  const std::size_t offset = from.value("byteOffset", 0);
  const std::size_t begin = view.value("byteOffset", 0);
  const std::size_t count =
      from["count"].get<std::size_t>() * (from["type"] == "SCALAR" ? 1 : 3) / (sizeof(T) / 4);
  CHECK((begin + offset) % 4 == 0);
  CHECK(stride % 4 == 0);
  CHECK(view["buffer"] == 0);
  REQUIRE(begin + view["byteLength"].get<std::size_t>() <= binary.size());
  REQUIRE((count - 1) * stride + offset + sizeof(T) <= view["byteLength"].get<std::size_t>());
  std::vector<T> out(count);
  for (std::size_t i = 0; i < count; ++i)
    std::memcpy(&out[i], binary.data() + begin + offset + i * stride, sizeof(T));
  return out;
}

inline GlbFile glb_file(const std::string& file) {
  GlbFile glb;
  REQUIRE(file.substr(0, 4) == "glTF");
  CHECK(number_at(file, 4) == 2);
  CHECK(number_at(file, 8) == file.size());
  const std::size_t json_bytes = number_at(file, 12);
  CHECK(file.substr(16, 4) == "JSON");
  CHECK(json_bytes % 4 == 0);
  glb.json = nlohmann::json::parse(file.substr(20, json_bytes));
  const std::size_t at = 20 + json_bytes;
  const std::size_t binary_bytes = number_at(file, at);
  CHECK(file.substr(at + 4, 4) == std::string("BIN\0", 4));
  CHECK(binary_bytes % 4 == 0);
  REQUIRE(at + 8 + binary_bytes == file.size());
  const std::string binary = file.substr(at + 8);
  CHECK(glb.json["buffers"][0]["byteLength"] == binary_bytes);
  CHECK(glb.json["asset"]["version"] == "2.0");

  const auto& node = glb.json["nodes"][glb.json["scenes"][0]["nodes"][0].get<std::size_t>()];
  if (node.contains("translation")) glb.offset = node["translation"].get<Point>();
  const auto& primitive = glb.json["meshes"][node["mesh"].get<std::size_t>()]["primitives"][0];
  constexpr unsigned floats = 5126;
  const std::size_t position = primitive["attributes"]["POSITION"];
  glb.positions = elements<std::array<float, 3>>(glb.json, binary, position, floats);
  if (primitive["attributes"].contains("NORMAL")) {
    glb.normals = elements<std::array<float, 3>>(glb.json, binary, primitive["attributes"]["NORMAL"], floats);
  }
  glb.faces = elements<std::array<std::uint32_t, 3>>(glb.json, binary, primitive["indices"], 5125);

  // min and max are of the floats that are there, and every index is of a vertex.
  for (std::size_t axis = 0; axis < 3; ++axis) {
    float low = glb.positions.at(0)[axis];
    float high = low;
    for (const auto& p : glb.positions) {
      low = std::min(low, p[axis]);
      high = std::max(high, p[axis]);
    }
    CHECK(glb.json["accessors"][position]["min"][axis] == static_cast<double>(low));
    CHECK(glb.json["accessors"][position]["max"][axis] == static_cast<double>(high));
  }
  for (const auto& face : glb.faces) {
    for (const std::uint32_t vertex : face) CHECK(vertex < glb.positions.size());
  }
  return glb;
}

}  // namespace winnow::test
