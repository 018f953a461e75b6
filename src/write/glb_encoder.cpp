// Binary glTF 2.0 (Khronos Group; ISO/IEC 12113): a header, a chunk of JSON, a chunk of vertices and indices.
#include <winnow/error.hpp>

#include "base/text.hpp"
#include "base/vector.hpp"
#include "write/append.hpp"
#include "write/mesh_encoder.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>

namespace winnow {

namespace {

constexpr std::size_t header_bytes = 12;
constexpr std::size_t chunk_header_bytes = 8;
constexpr std::uint64_t most_json = 4096;  // far more than is ever written

std::uint64_t stride(const MeshShape& shape) {
  return (shape.normals ? 6 : 3) * sizeof(float);
}

std::uint64_t binary_bytes(const MeshShape& shape) {
  return shape.vertices * stride(shape) + shape.faces * 3 * sizeof(std::uint32_t);
}

// GLB holds floats. A mesh of doubles that lies far from the origin is therefore written from a place
// near it, which its node carries back: on each axis the lower side of its box, rounded down to a multiple
// of the largest power of two that is not above the longest side, so that the steps of floats are small
// beside the mesh. A mesh within twice its size of the origin, and one of floats, stays where it is.
Point offset_of(const MeshShape& shape) {
  Point offset{};
  const double side = shape.box.longest_side();
  if (!shape.double_positions || shape.box.empty || !(side > 0)) return offset;
  const double step = std::ldexp(1.0, std::ilogb(side));
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const double low = shape.box.low[axis];
    const double high = shape.box.high[axis];
    if (std::max(std::abs(low), std::abs(high)) > 2 * side) offset[axis] = std::floor(low / step) * step;
  }
  return offset;
}

std::string list(const Point& values) {
  return "[" + shortest(values[0]) + "," + shortest(values[1]) + "," + shortest(values[2]) + "]";
}

// As the vertices are written.
Point as_written(const Point& position, const Point& offset) {
  Point out{};
  for (std::size_t axis = 0; axis < 3; ++axis) out[axis] = nearest_float(position[axis] - offset[axis]);
  return out;
}

std::string accessor(unsigned view, unsigned offset, unsigned component, std::uint64_t count,
                     const char* type) {
  return "{\"bufferView\":" + std::to_string(view) + ",\"byteOffset\":" + std::to_string(offset) +
         ",\"componentType\":" + std::to_string(component) + ",\"count\":" + std::to_string(count) +
         ",\"type\":\"" + type + "\"";
}

std::string json_of(const MeshShape& shape) {
  const Point offset = offset_of(shape);
  const std::uint64_t vertex_bytes = shape.vertices * stride(shape);
  const std::uint64_t index_bytes = shape.faces * 3 * sizeof(std::uint32_t);
  constexpr unsigned float_component = 5126;
  constexpr unsigned uint_component = 5125;
  std::string json = R"({"asset":{"version":"2.0","generator":"winnow"},"scene":0,"scenes":[{"nodes":[0]}],)";
  json += "\"nodes\":[{\"mesh\":0";
  if (offset != Point{}) json += ",\"translation\":" + list(offset);
  json += "}],\"meshes\":[{\"primitives\":[{\"attributes\":{\"POSITION\":0";
  if (shape.normals) json += ",\"NORMAL\":2";
  json += "},\"indices\":1}]}],\"accessors\":[";
  json += accessor(0, 0, float_component, shape.vertices, "VEC3") +
          ",\"min\":" + list(as_written(shape.box.low, offset)) +
          ",\"max\":" + list(as_written(shape.box.high, offset)) + "},";
  json += accessor(1, 0, uint_component, 3 * shape.faces, "SCALAR") + "}";
  if (shape.normals) json += "," + accessor(0, 12, float_component, shape.vertices, "VEC3") + "}";
  json += "],\"bufferViews\":[{\"buffer\":0,\"byteLength\":" + std::to_string(vertex_bytes) +
          ",\"byteStride\":" + std::to_string(stride(shape)) + ",\"target\":34962},";
  json += "{\"buffer\":0,\"byteOffset\":" + std::to_string(vertex_bytes) +
          ",\"byteLength\":" + std::to_string(index_bytes) + ",\"target\":34963}],";
  json += "\"buffers\":[{\"byteLength\":" + std::to_string(binary_bytes(shape)) + "}]}";
  json.resize((json.size() + 3) / 4 * 4, ' ');
  return json;
}

void check_size(const MeshShape& shape) {
  constexpr std::uint64_t most = UINT32_MAX - most_json;
  // Each term by itself first: the sum must not overflow.
  const bool fits = shape.vertices < most && shape.faces < most && binary_bytes(shape) <= most;
  if (fits) return;
  throw Error(ErrorKind::usage,
              "GLB holds 4 GiB, too little for " + grouped(shape.faces) +
                  " faces; ask for fewer (at most about 230 million), or for PLY, OBJ, OFF or STL");
}

void check_floats(const Box& box) {
  constexpr double most = std::numeric_limits<float>::max();
  for (const Point& corner : {box.low, box.high}) {
    for (const double value : corner) {
      if (std::abs(value) <= most) continue;
      throw Error(ErrorKind::usage, "GLB holds floats, too small for coordinates like " + shortest(value) +
                                        "; ask for PLY, OBJ or OFF");
    }
  }
}

class GlbEncoder final : public MeshEncoder {
 public:
  [[nodiscard]] std::string header(const MeshShape& shape) const override {
    check_size(shape);
    check_floats(shape.box);
    const std::string json = json_of(shape);
    std::vector<std::byte> head;
    append(head, std::array{'g', 'l', 'T', 'F'});
    append(head, std::uint32_t{2});
    append(head, static_cast<std::uint32_t>(header_bytes + 2 * chunk_header_bytes + json.size() +
                                            binary_bytes(shape)));
    append(head, static_cast<std::uint32_t>(json.size()));
    append(head, std::array{'J', 'S', 'O', 'N'});
    std::string text(reinterpret_cast<const char*>(head.data()), head.size());
    text += json;
    head.clear();
    append(head, static_cast<std::uint32_t>(binary_bytes(shape)));
    append(head, std::array{'B', 'I', 'N', '\0'});
    return text.append(reinterpret_cast<const char*>(head.data()), head.size());
  }

  void vertices(const MeshShape& shape, std::span<const MeshVertex> vertices,
                std::vector<std::byte>& out) const override {
    const Point offset = offset_of(shape);
    for (const MeshVertex& vertex : vertices) {
      for (std::size_t axis = 0; axis < 3; ++axis)
        append(out, static_cast<float>(vertex.position[axis] - offset[axis]));
      if (!shape.normals) continue;
      // A normal of no length is not allowed; any other is as good for a vertex that has none.
      const bool none = vertex.normal == std::array<float, 3>{};
      append(out, none ? std::array{0.0F, 0.0F, 1.0F} : vertex.normal);
    }
  }

  void faces(const MeshShape& /*shape*/, std::span<const MeshFace> faces,
             std::span<const Corners> /*corners*/, std::vector<std::byte>& out) const override {
    for (const MeshFace& face : faces) {
      for (const std::uint64_t vertex : face.vertex) append(out, static_cast<std::uint32_t>(vertex));
    }
  }

  [[nodiscard]] bool needs_box() const override { return true; }
};

}  // namespace

std::unique_ptr<MeshEncoder> make_glb_encoder() {
  return std::make_unique<GlbEncoder>();
}

}  // namespace winnow
