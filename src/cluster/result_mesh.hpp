// The last steps of clustering: cells become vertices, faces between cells become faces between
// vertices.
#pragma once

#include "cluster/attribute_means.hpp"
#include "cluster/boundary_sum.hpp"
#include "cluster/cell_sum.hpp"
#include "cluster/clusterer.hpp"
#include "io/sorted_runs.hpp"

namespace winnow {

// Cells come in key order; those that no output face uses leave no vertex. `boundaries`, in the
// same order: null where vertices need not keep to them. `attributes`: null where none are carried.
// Fills mesh.vertices, quadrics, attributes and cells. Throws Error(failed) beyond 2^32 - 1
// vertices.
template <typename Sum>
void collect_vertices(Job& job, RecordCursor<Sum>& cells, RecordCursor<BoundarySum>* boundaries,
                      AttributeCursor* attributes, const ClusterSettings& settings,
                      std::uint64_t memory, ClusteredMesh& mesh);

// Faces come in key order; the same three cells give one face. Each is turned to agree with the
// normals of its cells, if `turn`. Fills the rest of `mesh`.
void collect_faces(Job& job, RecordCursor<CellFace>& faces, std::uint64_t memory, bool turn,
                   ClusteredMesh& mesh);

}  // namespace winnow
