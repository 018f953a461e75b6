// The last steps of clustering: cells become vertices, faces between cells become faces between
// vertices.
#pragma once

#include "cluster/attribute_means.hpp"
#include "cluster/boundary_sum.hpp"
#include "cluster/cell_sum.hpp"
#include "cluster/clusterer.hpp"
#include "io/sorted_runs.hpp"

#include <memory>

namespace winnow {

// All cells in key order, with what was summed up of each.
template <typename Sum>
struct MergedCells {
  std::unique_ptr<RecordCursor<Sum>> sums;
  // Null where vertices need not keep to boundaries, and where nothing is carried.
  std::unique_ptr<RecordCursor<BoundarySum>> boundaries;
  std::unique_ptr<AttributeCursor> attributes;
};

// Cells that no output face uses leave no vertex. Fills the vertices of the mesh and what is beside
// them. Throws Error(failed) beyond 2^32 - 1 vertices.
template <typename Sum>
void build_vertices(Job& job, MergedCells<Sum> cells, const ClusterSettings& settings,
                    ClusterResult& result);

// Faces come in key order; the same three cells give one face. Each is turned to agree with the
// normals of its cells, if `turn`. Fills the rest.
void build_faces(Job& job, RecordCursor<CellFace>& faces, bool turn, ClusterResult& result);

}  // namespace winnow
