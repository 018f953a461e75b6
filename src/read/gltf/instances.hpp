// Where the instances of a mesh stand, by EXT_mesh_gpu_instancing.
#pragma once

#include "read/gltf/accessor.hpp"

#include <optional>
#include <string>
#include <vector>

namespace winnow {

class GltfInstanceReader {
 public:
  // Throws Error(bad_input) where what instances have is not of one count.
  GltfInstanceReader(GltfBytes& bytes, const GltfDocument& document, const GltfInstances& instances,
                     const std::string& name);

  // Of the next instances, some thousands, where each stands in its node; empty at the end. Other
  // accessors may be read between two calls.
  std::vector<GltfTransform> next();

 private:
  std::optional<GltfElements> translations_, rotations_, scales_;
};

}  // namespace winnow
