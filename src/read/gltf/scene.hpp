// The nodes of a glTF: which meshes stand where.
#pragma once

#include "read/gltf/json.hpp"
#include "read/gltf/transform.hpp"

#include <cstddef>
#include <optional>
#include <vector>

namespace winnow {

// EXT_mesh_gpu_instancing: accessors of how each instance is placed in its node.
struct GltfInstances {
  std::optional<std::size_t> translations, rotations, scales;
};

// A mesh where it stands in the scene.
struct GltfPlacedMesh {
  std::size_t mesh = 0;
  GltfTransform to_world = gltf_identity;
  std::optional<GltfInstances> instances;
  std::size_t node = 0;
};

// Of so many meshes and accessors, all moved by `center`, in the order of the default scene;
// without scenes from every node that is nobody's child on; without nodes every mesh as it is.
// Throws Error(bad_input), also where nodes are no trees.
std::vector<GltfPlacedMesh> place_meshes(const GltfJson& json, std::size_t meshes,
                                         std::size_t accessors, const Point& center);

}  // namespace winnow
