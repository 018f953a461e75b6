// A GLB of one mesh, taken apart by the rules of the glTF 2.0 specification and of
// EXT_meshopt_compression.
#pragma once

#include "base/vector.hpp"

#include <algorithm>
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
  unsigned color_type = 0;
  std::vector<std::array<std::uint32_t, 3>> faces;
};

inline std::uint32_t number_at(const std::string& file, std::size_t at) {
  std::uint32_t number = 0;
  REQUIRE(at + sizeof number <= file.size());
  std::memcpy(&number, file.data() + at, sizeof number);
  return number;
}

// The plain bytes of a view.
inline std::string bytes_of_view(const nlohmann::json& json, const std::string& binary,
                                 std::size_t number) {
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
  const int failed =
      packed["mode"] == "TRIANGLES"
          ? meshopt_decodeIndexBuffer(plain.data(), count, stride, from, packed_length)
          : meshopt_decodeVertexBuffer(plain.data(), count, stride, from, packed_length);
  REQUIRE(failed == 0);
  return plain;
}

// A component as it is stored; of a normalized one the number from -1 or 0 to 1 that it stands for.
inline double component_at(const char* at, unsigned type, bool normalized) {
  const auto load = [at]<typename T>(T value) {
    std::memcpy(&value, at, sizeof value);
    return static_cast<double>(value);
  };
  switch (type) {
    case 5120:
      return load(std::int8_t{}) / (normalized ? 127 : 1);
    case 5121:
      return load(std::uint8_t{}) / (normalized ? 255 : 1);
    case 5123:
      return load(std::uint16_t{}) / (normalized ? 65535 : 1);
    case 5125:
      return load(std::uint32_t{});
    default:
      CHECK(type == 5126);
      return load(float{});
  }
}

// The elements of an accessor, which must lie within their view, each part at a whole word.
template <std::size_t Components>
std::vector<std::array<double, Components>> elements(const nlohmann::json& json,
                                                     const std::string& binary,
                                                     std::size_t accessor,
                                                     const std::vector<unsigned>& allowed) {
  const auto& from = json["accessors"].at(accessor);
  const std::size_t number = from["bufferView"];
  const std::string bytes = bytes_of_view(json, binary, number);
  const unsigned type = from["componentType"];
  CHECK(std::find(allowed.begin(), allowed.end(), type) != allowed.end());
  CHECK(from["type"] ==
        (Components == 1 ? std::string("SCALAR") : "VEC" + std::to_string(Components)));
  const std::size_t size = type <= 5121 ? 1 : type == 5123 ? 2 : 4;
  const std::size_t stride = json["bufferViews"][number].value("byteStride", Components * size);
  const std::size_t offset = from.value("byteOffset", 0);
  const std::size_t count = from["count"];
  CHECK(offset % 4 == 0);
  CHECK((Components == 1 || stride % 4 == 0));
  REQUIRE((count - 1) * stride + offset + Components * size <= bytes.size());
  std::vector<std::array<double, Components>> out(count);
  for (std::size_t i = 0; i < count; ++i) {
    for (std::size_t k = 0; k < Components; ++k) {
      out[i][k] = component_at(bytes.data() + offset + i * stride + k * size, type,
                               from.value("normalized", false));
    }
  }
  return out;
}

inline void add_primitive(GlbFile& glb, const nlohmann::json& primitive,
                          const std::string& binary) {
  constexpr unsigned int8 = 5120, uint8 = 5121, uint16 = 5123, uint32 = 5125, float32 = 5126;
  const auto& attributes = primitive["attributes"];
  const bool quantized = glb.json.dump().find("KHR_mesh_quantization") != std::string::npos;
  const std::size_t position = attributes["POSITION"];
  const auto positions = elements<3>(glb.json, binary, position, {quantized ? uint16 : float32});
  // min and max are of the numbers that are there, and every index is of a vertex.
  for (std::size_t axis = 0; axis < 3; ++axis) {
    double low = positions.at(0)[axis];
    double high = low;
    for (const auto& p : positions) {
      low = std::min(low, p[axis]);
      high = std::max(high, p[axis]);
    }
    CHECK(glb.json["accessors"][position]["min"][axis] == low);
    CHECK(glb.json["accessors"][position]["max"][axis] == high);
  }
  const auto first = static_cast<std::uint32_t>(glb.positions.size());
  const std::size_t indices = primitive["indices"];
  const auto corners =
      elements<1>(glb.json, binary, indices, {positions.size() <= UINT16_MAX ? uint16 : uint32});
  REQUIRE(corners.size() % 3 == 0);
  for (std::size_t i = 0; i < corners.size(); ++i) {
    REQUIRE(corners[i][0] < static_cast<double>(positions.size()));
    if (i % 3 == 0) glb.faces.emplace_back();
    glb.faces.back().at(i % 3) = first + static_cast<std::uint32_t>(corners[i][0]);
  }
  const auto add = [&](const std::array<double, 3>& p, std::vector<std::array<float, 3>>& to) {
    to.push_back({static_cast<float>(p[0]), static_cast<float>(p[1]), static_cast<float>(p[2])});
  };
  for (const auto& p : positions) add(p, glb.positions);
  if (attributes.contains("NORMAL")) {
    const auto normals =
        elements<3>(glb.json, binary, attributes["NORMAL"], {quantized ? int8 : float32});
    CHECK(normals.size() == positions.size());
    for (const auto& n : normals) add(n, glb.normals);
  }
  const auto append_colors = [&]<std::size_t Components>(std::size_t accessor) {
    const auto colors = elements<Components>(glb.json, binary, accessor, {uint8, uint16, float32});
    CHECK(colors.size() == positions.size());
    for (const auto& color : colors) {
      for (const double component : color) glb.colors.push_back(static_cast<float>(component));
    }
  };
  if (attributes.contains("COLOR_0")) {
    const std::size_t accessor = attributes["COLOR_0"];
    glb.color_type = glb.json["accessors"][accessor]["componentType"];
    if (glb.json["accessors"][accessor]["type"] == "VEC4") {
      append_colors.operator()<4>(accessor);
    } else {
      append_colors.operator()<3>(accessor);
    }
  }
  CHECK(primitive["material"] == 0);
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
  CHECK(glb.json["materials"][0]["pbrMetallicRoughness"]["metallicFactor"] == 0);

  const auto& node = glb.json["nodes"][glb.json["scenes"][0]["nodes"][0].get<std::size_t>()];
  if (node.contains("translation")) glb.offset = node["translation"].get<Point>();
  for (const auto& primitive : glb.json["meshes"][node["mesh"].get<std::size_t>()]["primitives"])
    add_primitive(glb, primitive, binary);
  return glb;
}

}  // namespace winnow::test
