// The last step of refinement: flipped faces are turned over, tile by tile.
#pragma once

#include "mesh/stored_mesh.hpp"
#include "stitch/reference_mesh.hpp"
#include "stitch/refine_settings.hpp"

#include <memory>

namespace winnow {

// The vertices of `mesh`, some of them moved (decimate/unfold.hpp). `reference`: the mesh
// that refinement began with.
std::unique_ptr<VertexIndex> unfolded_vertices(Job& job, const StoredMesh& mesh,
                                               const ReferenceMesh& reference,
                                               const RefineSettings& settings,
                                               const RefineMemory& memory);
std::unique_ptr<VertexIndex> unfolded_vertices(Job& job, const StoredMesh& mesh,
                                               const StoredMesh& reference,
                                               const RefineSettings& settings,
                                               const RefineMemory& memory);

}  // namespace winnow
