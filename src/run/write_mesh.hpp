// The last station: a clustered mesh as a file.
#pragma once

#include "cluster/clusterer.hpp"
#include "io/byte_sink.hpp"
#include "io/job.hpp"
#include "write/mesh_encoder.hpp"

namespace winnow {

// Encodes with all threads, writes in order; does not finish() the sink.
void write_mesh(Job& job, const ClusteredMesh& mesh, const MeshShape& shape, const MeshEncoder& encoder,
                ByteSink& sink);

}  // namespace winnow
