// glTF 2.0 files, piece by piece.
#pragma once

#include "support/polygons.hpp"

#include <cstdint>
#include <cstring>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

namespace winnow::test {

using Json = nlohmann::ordered_json;

template <typename Number>
void put_number(std::string& bytes, Number number) {
  bytes.append(reinterpret_cast<const char*>(&number), sizeof number);
}

class GltfBuilder {
 public:
  Json json{{"asset", {{"version", "2.0"}}}, {"buffers", Json::array()}};
  std::string buffer;

  std::size_t view(const std::string& bytes, std::size_t stride = 0) {
    buffer.resize((buffer.size() + 3) / 4 * 4);
    Json one{{"buffer", 0}, {"byteOffset", buffer.size()}, {"byteLength", bytes.size()}};
    if (stride != 0) one["byteStride"] = stride;
    buffer += bytes;
    return add("bufferViews", one);
  }

  std::size_t add(const char* list, const Json& value) {
    json[list].push_back(value);
    return json[list].size() - 1;
  }

  std::size_t positions(const std::vector<Point>& points, std::size_t stride = 12) {
    std::string bytes;
    for (const Point& p : points) {
      for (const double x : p) put_number(bytes, static_cast<float>(x));
      bytes.resize(bytes.size() + stride - 12, '\x7f');
    }
    return add("accessors", {{"bufferView", view(bytes, stride == 12 ? 0 : stride)},
                             {"componentType", 5126},
                             {"count", points.size()},
                             {"type", "VEC3"}});
  }

  std::size_t indices(const std::vector<std::uint64_t>& values, int type) {
    std::string bytes;
    for (const std::uint64_t value : values) {
      if (type == 5121) put_number(bytes, static_cast<std::uint8_t>(value));
      if (type == 5123) put_number(bytes, static_cast<std::uint16_t>(value));
      if (type == 5125) put_number(bytes, static_cast<std::uint32_t>(value));
    }
    return add("accessors", {{"bufferView", view(bytes)},
                             {"componentType", type},
                             {"count", values.size()},
                             {"type", "SCALAR"}});
  }

  // A view that decodes to `count` elements of `stride` bytes. `filter`: empty for none.
  std::size_t packed_view(const std::vector<unsigned char>& packed, const char* mode,
                          std::size_t count, std::size_t stride, const std::string& filter = "") {
    const std::size_t number = view({packed.begin(), packed.end()});
    Json& one = json["bufferViews"][number];
    Json how{{"buffer", 0},
             {"byteOffset", one["byteOffset"]},
             {"byteLength", packed.size()},
             {"byteStride", stride},
             {"mode", mode},
             {"count", count}};
    if (!filter.empty()) how["filter"] = filter;
    one["extensions"] = {{"EXT_meshopt_compression", how}};
    one["byteLength"] = count * stride;
    if (std::string(mode) == "ATTRIBUTES") one["byteStride"] = stride;
    return number;
  }

  // Elements as they stand, one behind the other; `type`: "VEC3", say.
  template <typename Number>
  std::size_t numbers(const std::vector<Number>& values, int component, const std::string& type,
                      bool normalized = false, std::size_t stride = 0) {
    std::string bytes;
    const std::size_t components = type == "VEC4" ? 4 : 3;
    for (std::size_t i = 0; i < values.size(); ++i) {
      if (i > 0 && i % components == 0 && stride != 0)
        bytes.resize(bytes.size() + stride - components * sizeof(Number), '\x7f');
      put_number(bytes, values[i]);
    }
    Json accessor{{"bufferView", view(bytes, stride)},
                  {"componentType", component},
                  {"count", values.size() / components},
                  {"type", type}};
    if (normalized) accessor["normalized"] = true;
    return add("accessors", accessor);
  }

  std::size_t mesh(const Json& primitives) { return add("meshes", {{"primitives", primitives}}); }

  [[nodiscard]] std::string glb() const {
    Json whole = json;
    if (whole["buffers"].empty()) whole["buffers"].push_back({{"byteLength", buffer.size()}});
    std::string text = whole.dump();
    text.resize((text.size() + 3) / 4 * 4, ' ');
    std::string binary = buffer;
    binary.resize((binary.size() + 3) / 4 * 4);
    std::string file = "glTF";
    put_number(file, std::uint32_t{2});
    put_number(file, static_cast<std::uint32_t>(28 + text.size() + binary.size()));
    put_number(file, static_cast<std::uint32_t>(text.size()));
    file += "JSON" + text;
    put_number(file, static_cast<std::uint32_t>(binary.size()));
    return file + std::string("BIN\0", 4) + binary;
  }

  // As JSON alone: the buffer is the file `uri`, or, where that is empty, in it.
  [[nodiscard]] std::string gltf(const std::string& uri = "") const {
    Json whole = json;
    whole["buffers"] = {
        {{"byteLength", buffer.size()},
         {"uri", uri.empty() ? "data:application/octet-stream;base64," + base64() : uri}}};
    return whole.dump(1);
  }

 private:
  [[nodiscard]] std::string base64() const {
    constexpr const char* digits =
        "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string text;
    for (std::size_t i = 0; i < buffer.size(); i += 3) {
      std::uint32_t bits = 0;
      for (std::size_t k = 0; k < 3; ++k)
        bits = bits << 8 | (i + k < buffer.size() ? static_cast<unsigned char>(buffer[i + k]) : 0U);
      for (std::size_t k = 0; k < 4; ++k)
        text += i + k > buffer.size() ? '=' : digits[bits >> (18 - 6 * k) & 63];
    }
    return text;
  }
};

// The corners of all faces, which must be triangles, one after the other.
inline std::vector<std::uint64_t> corners_of(const Polygons& mesh) {
  std::vector<std::uint64_t> all;
  for (const auto& face : mesh.faces) {
    for (const std::int64_t index : face) all.push_back(static_cast<std::uint64_t>(index));
  }
  return all;
}

// A mesh of triangles, its positions as floats.
inline GltfBuilder gltf_of(const Polygons& mesh, int index_type = 5125) {
  GltfBuilder file;
  const std::size_t positions = file.positions(mesh.vertices);
  const std::size_t indices = file.indices(corners_of(mesh), index_type);
  file.mesh(Json::array({{{"attributes", {{"POSITION", positions}}}, {"indices", indices}}}));
  return file;
}

}  // namespace winnow::test
