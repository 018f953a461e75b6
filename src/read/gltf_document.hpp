// What a glTF 2.0 says about its triangles: the JSON, checked, as far as positions need it.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace winnow {

enum class GltfType : std::uint8_t { int8, uint8, int16, uint16, uint32, float32 };

std::size_t size_of(GltfType type);

struct GltfBuffer {
  std::optional<std::string> uri;  // none: the GLB's own
  std::uint64_t bytes = 0;
};

// EXT_meshopt_compression: the view's bytes are what `count` elements decode to.
struct GltfPacking {
  enum class Mode : std::uint8_t { attributes, triangles, indices };
  enum class Filter : std::uint8_t { none, exponential, other };
  std::size_t buffer = 0;
  std::uint64_t offset = 0, bytes = 0, count = 0, stride = 0;
  Mode mode{};
  Filter filter{};
};

struct GltfView {
  std::size_t buffer = 0;
  std::uint64_t offset = 0, bytes = 0;
  std::uint64_t stride = 0;  // 0: elements stand close
  std::optional<GltfPacking> packing;
};

// A part of a view, as an accessor or its sparse arrays name it.
struct GltfSlice {
  std::size_t view = 0;
  std::uint64_t offset = 0;
};

// What differs from an accessor's base.
struct GltfSparse {
  std::uint64_t count = 0;
  GltfSlice indices, values;
  GltfType index_type{};
};

struct GltfAccessor {
  std::optional<GltfSlice> base;  // none: zeros
  GltfType type{};
  unsigned components = 0;  // 1: scalars; 3: points; 0: something else
  bool normalized = false;
  std::uint64_t count = 0;
  std::optional<GltfSparse> sparse;
};

struct GltfPrimitive {
  enum class Mode : std::uint8_t { triangles, strip, fan };
  Mode mode{};
  std::size_t positions = 0;  // accessors
  std::optional<std::size_t> indices;
};

// Rows of a matrix that takes points to the parent's space; its last row is 0 0 0 1.
using GltfTransform = std::array<std::array<double, 4>, 3>;
inline constexpr GltfTransform gltf_identity{{{1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 1, 0}}};
GltfTransform operator*(const GltfTransform& a, const GltfTransform& b);

// A mesh where it stands in the scene.
struct GltfPlacedMesh {
  std::size_t mesh = 0;
  GltfTransform to_world = gltf_identity;
};

struct GltfDocument {
  std::vector<GltfBuffer> buffers;
  std::vector<GltfView> views;
  std::vector<GltfAccessor> accessors;
  std::vector<std::vector<GltfPrimitive>> meshes;
  std::vector<GltfPlacedMesh> placed;  // in the default scene, in its order
  std::uint64_t other_primitives = 0;  // points, lines and what has no positions, left out of `meshes`
  std::vector<std::string> unread;     // what primitives have besides, in words
};

// Throws Error(bad_input), beginning with `name`, where the text is no such JSON, where it names what is not
// there, and where it needs an extension that is not known.
GltfDocument parse_gltf(std::string_view json, const std::string& name);

// Memory that parse_gltf takes at most, for its values and strings, found by looking over the text.
std::uint64_t memory_to_parse_gltf(std::string_view json);

}  // namespace winnow
