// The nodes of a glTF: which meshes stand where.
#pragma once

#include "read/gltf_json.hpp"
#include "read/gltf_transform.hpp"

#include <cstddef>
#include <vector>

namespace winnow {

// A mesh where it stands in the scene.
struct GltfPlacedMesh {
  std::size_t mesh = 0;
  GltfTransform to_world = gltf_identity;
};

// In the order of the default scene; without scenes from every node that is nobody's child on; without nodes
// every mesh as it is. Throws Error(bad_input), also where nodes are no trees.
std::vector<GltfPlacedMesh> place_meshes(const GltfJson& json, std::size_t meshes);

}  // namespace winnow
