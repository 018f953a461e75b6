// What a glTF 2.0 says about its triangles: the JSON, checked, as far as they need it.
#pragma once

#include "base/morph_clip.hpp"
#include "read/gltf/scene.hpp"

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
  enum class Filter : std::uint8_t { none, octahedral, exponential, other };
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
  unsigned components = 0;  // 1: scalars; 3 or 4: vectors; 0: something else
  bool normalized = false;
  std::uint64_t count = 0;
  std::optional<GltfSparse> sparse;
};

struct GltfPrimitive {
  enum class Mode : std::uint8_t { triangles, strip, fan };
  Mode mode{};
  // Accessors; those of vertices have as many elements.
  std::size_t positions = 0;
  std::optional<std::size_t> indices, normals, colors;
  // Of each morph target: what it adds to positions, normals and colours, if anything.
  struct Target {
    std::optional<std::size_t> positions, normals, colors;
  };
  std::vector<Target> targets;
};

// An animation of the weights of a node's morph targets: accessors.
struct GltfWeights {
  std::string name;
  std::size_t node = 0, times = 0, weights = 0;
  MorphClip::Between between{};
};

struct GltfDocument {
  std::vector<GltfBuffer> buffers;
  std::vector<GltfView> views;
  std::vector<GltfAccessor> accessors;
  std::vector<std::vector<GltfPrimitive>> meshes;
  std::vector<GltfPlacedMesh> placed;  // in the default scene, in its order
  std::optional<Point> center;         // CESIUM_RTC: was added to all
  std::vector<GltfWeights> weights;
  bool weights_alone = true;  // nothing else is animated
  std::uint64_t other_primitives =
      0;                            // points, lines and what has no positions, left out of `meshes`
  std::uint64_t other_points = 0;   // of these
  std::vector<std::string> unread;  // what primitives have besides, in words
};

// Of what is unread: what a sequence reads after all.
inline constexpr const char* unread_targets = "morph targets and their weights";
inline constexpr const char* unread_animations = "animations";

// Throws Error(bad_input), beginning with `name`, where the text is no such JSON, where it names
// what is not there, and where it needs an extension that is not known.
GltfDocument parse_gltf(std::string_view json, const std::string& name);

// Memory that parse_gltf takes at most, for its values and strings, found by looking over the text.
std::uint64_t memory_to_parse_gltf(std::string_view json);

}  // namespace winnow
