// A surface as the bytes of a file, block by block.
#pragma once

#include "generate/generate.hpp"
#include "generate/scatter.hpp"
#include "generate/surface.hpp"
#include "io/byte_sink.hpp"
#include "io/job.hpp"
#include "write/mesh_encoder.hpp"

namespace winnow {

struct SurfaceFile {
  const GeneratedSurface& surface;
  const MeshEncoder& encoder;
  const GenerateOptions& options;
  MeshShape shape;
};

// Writes all vertices and all faces. Throws Error(resources), Error(cancelled).
void stream_surface(Job& job, const SurfaceFile& file, ByteSink& sink);

}  // namespace winnow
