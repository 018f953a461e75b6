// An input with vertices of its own as a mesh, just as it is.
#pragma once

#include "cluster/clusterer.hpp"
#include "io/job.hpp"
#include "read/mesh_reader.hpp"

namespace winnow {

// All vertices, with the attributes that the reader carries as they are stored, and all good faces,
// in the order of the input; a vertex that is not finite stands where the first that is finite
// does, and a note says so. Fills `counts` of the faces. The mesh's faces do not begin with their
// lowest vertex, nor come in the order of those: it is good for write_mesh() alone.
StoredMesh plain_mesh(Job& job, MeshReader& reader, const MeshMemory& memory,
                      ClusterCounts& counts);

}  // namespace winnow
