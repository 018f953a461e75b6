// The triangles of a glTF whose JSON was parsed.
#pragma once

#include "read/gltf/attributes.hpp"
#include "read/gltf/file.hpp"
#include "read/mesh_reader.hpp"

#include <cstddef>
#include <memory>
#include <optional>

namespace winnow {

// `source` must be seekable. `target`: the morph target that is added to positions, from 0.
std::unique_ptr<MeshReader> open_gltf_document(Job& job, std::unique_ptr<ByteSource> source,
                                               const ReaderMemory& memory,
                                               const AttributeRequest& wish, const GltfFile& file,
                                               const GltfAttributes& attributes,
                                               std::optional<std::size_t> target);

}  // namespace winnow
