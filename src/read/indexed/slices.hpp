// From raw batches that are decoded already to face batches.
#pragma once

#include "read/corner_streams.hpp"
#include "read/indexed/vertex_store.hpp"
#include "read/mesh_reader.hpp"

namespace winnow {

// Batches of vertex indices; the indices are checked here.
void slice_indices(const RawBatch& batch, const VertexStore& vertices, FaceBatch& slice,
                   const FaceSink& sink);

// The same for one slice whose indices the caller has laid side by side: `index[corner]` is changed
// where it names no vertex, and the slice's status says so.
void gather_checked(const VertexStore& vertices, const std::array<std::uint32_t*, 3>& index,
                    FaceBatch& slice);

// The same of batches whose vertices were brought together.
void slice_records(const RawBatch& batch, const VertexStore& vertices, const CornerStreams& streams,
                   FaceBatch& slice, const FaceSink& sink);

// Batches of corner positions.
void slice_corners(const RawBatch& batch, FaceBatch& slice, const FaceSink& sink);

// All corners of a slice as three position views.
void corners_as_positions(const FaceBatch& slice, const PositionSink& sink);

}  // namespace winnow
