// A glTF file's parts: the JSON, taken within the budget, and the buffer of a GLB.
#pragma once

#include "io/byte_source.hpp"
#include "io/job.hpp"
#include "read/gltf/document.hpp"

#include <cstdint>

namespace winnow {

struct GltfFile {
  bool binary = false;  // GLB
  std::uint64_t json_end = 0;
  GltfDocument document;
  Reservation memory;  // of the document
};

// Reads no further than the JSON, and not past it: of a pipe, too. The source must be at its
// beginning. Throws Error: bad_input, resources.
GltfFile peek_gltf(Job& job, ByteSource& source);

// Where the buffer in a GLB stands; nothing where it has none. The source must be seekable.
struct GltfOwnBuffer {
  std::uint64_t begin = 0, bytes = 0;
};
GltfOwnBuffer own_buffer_of(ByteSource& source, const GltfFile& file);

}  // namespace winnow
