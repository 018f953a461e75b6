// A GLB of one mesh, taken apart by the rules of the glTF 2.0 specification and of EXT_meshopt_compression.
#pragma once

#include "base/vector.hpp"

#include <array>
#include <cstdint>
#include <cstring>
#include <string>
#include <vector>

#include <catch2/catch.hpp>
#include <meshoptimizer.h>
#include <nlohmann/json.hpp>

namespace winnow::test {

struct GlbFile {
  nlohmann::json json;
  Point offset{};
  std::size_t primitives = 0;
  // Of all primitives, one after the other.
  std::vector<std::array<float, 3>> positions, normals;
  std::vector<float> colors;  // three or four of each vertex
  std::vector<std::array<std::uint32_t, 3>> faces;
};

inline std::uint32_t number_at(const std::string& file, std::size_t at) {
  std::uint32_t number = 0;
  REQUIRE(at + sizeof number <= file.size());
  std::memcpy(&number, file.data() + at, sizeof number);
  return number;
}

// The plain bytes of a view.
inline std::string bytes_of_view(const nlohmann::json& json, const std::string& binary, std::size_t number) {
  const auto& view = json["bufferViews"].at(number);
  const std::size_t begin = view.value("byteOffset", 0);
  const std::size_t length = view["byteLength"];
  const auto& buffer = json["buffers"].at(view["buffer"].get<std::size_t>());
  REQUIRE(begin + length <= buffer["byteLength"].get<std::size_t>());
  if (!view.contains("extensions")) {
    CHECK(view["buffer"] == 0);
    return binary.substr(begin, length);
  }
  CHECK(buffer["extensions"]["EXT_meshopt_compression"]["fallback"] == true);
  const auto& packed = view["extensions"]["EXT_meshopt_compression"];
  CHECK(packed["buffer"] == 0);
  const std::size_t at = packed["byteOffset"];
  const std::size_t packed_length = packed["byteLength"];
  const std::size_t stride = packed["byteStride"];
  const std::size_t count = packed["count"];
  REQUIRE(at % 4 == 0);
  REQUIRE(at + packed_length <= binary.size());
  REQUIRE(count * stride == length);
  const auto* from = reinterpret_cast<const unsigned char*>(binary.data() + at);
  std::string plain(length, '\0');
  const int failed = packed["mode"] == "TRIANGLES"
                         ? meshopt_decodeIndexBuffer(plain.data(), count, stride, from, packed_length)
                         : meshopt_decodeVertexBuffer(plain.data(), count, stride, from, packed_length);
  REQUIRE(failed == 0);
  return plain;
}

// The elements of an accessor, which must lie within their view, as T.
template <typename T>
std::vector<T> elements(const nlohmann::json& json, const std::string& binary, std::size_t accessor,
                        unsigned component) {
  const auto& from = json["accessors"].at(accessor);
  const std::size_t number = from["bufferView"];
  const std::string bytes = bytes_of_view(json, binary, number);
  CHECK(from["componentType"] == component);
  const std::size_t stride = json["bufferViews"][number].value("byteStride", sizeof(T));
  const std::size_t offset = from.value("byteOffset", 0);
  const std::size_t components = from["type"] == "SCALAR" ? 1 : from["type"] == "VEC3" ? 3 : 4;
  const std::size_t scalars = from["count"].get<std::size_t>() * components;
  const std::size_t count = scalars / (sizeof(T) / 4);
  CHECK(offset % 4 == 0);
  CHECK(stride % 4 == 0);
  REQUIRE((count - 1) * stride + offset + sizeof(T) <= bytes.size());
  std::vector<T> out(count);
  for (std::size_t i = 0; i < count; ++i) std::memcpy(&out[i], bytes.data() + offset + i * stride, sizeof(T));
  return out;
}

inline void add_primitive(GlbFile& glb, const nlohmann::json& primitive, const std::string& binary) {
  constexpr unsigned floats = 5126;
  constexpr unsigned numbers = 5125;
  const std::size_t position = primitive["attributes"]["POSITION"];
  const auto positions = elements<std::array<float, 3>>(glb.json, binary, position, floats);
  // min and max are of the floats that are there, and every index is of a vertex.
  for (std::size_t axis = 0; axis < 3; ++axis) {
    float low = positions.at(0)[axis];
    float high = low;
    for (const auto& p : positions) {
      low = std::min(low, p[axis]);
      high = std::max(high, p[axis]);
    }
    CHECK(glb.json["accessors"][position]["min"][axis] == static_cast<double>(low));
    CHECK(glb.json["accessors"][position]["max"][axis] == static_cast<double>(high));
  }
  const auto first = static_cast<std::uint32_t>(glb.positions.size());
  for (auto face : elements<std::array<std::uint32_t, 3>>(glb.json, binary, primitive["indices"], numbers)) {
    for (std::uint32_t& vertex : face) {
      REQUIRE(vertex < positions.size());
      vertex += first;
    }
    glb.faces.push_back(face);
  }
  glb.positions.insert(glb.positions.end(), positions.begin(), positions.end());
  if (primitive["attributes"].contains("NORMAL")) {
    const auto normals =
        elements<std::array<float, 3>>(glb.json, binary, primitive["attributes"]["NORMAL"], floats);
    CHECK(normals.size() == positions.size());
    glb.normals.insert(glb.normals.end(), normals.begin(), normals.end());
  }
  const auto append_colors = [&]<std::size_t Components>(std::size_t accessor) {
    const auto colors = elements<std::array<float, Components>>(glb.json, binary, accessor, floats);
    CHECK(colors.size() == positions.size());
    for (const auto& color : colors) glb.colors.insert(glb.colors.end(), color.begin(), color.end());
  };
  if (primitive["attributes"].contains("COLOR_0")) {
    const std::size_t accessor = primitive["attributes"]["COLOR_0"];
    if (glb.json["accessors"][accessor]["type"] == "VEC4") {
      append_colors.operator()<4>(accessor);
    } else {
      append_colors.operator()<3>(accessor);
    }
  }
  ++glb.primitives;
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
  for (const auto& primitive : glb.json["meshes"][node["mesh"].get<std::size_t>()]["primitives"])
    add_primitive(glb, primitive, binary);
  return glb;
}

}  // namespace winnow::test
