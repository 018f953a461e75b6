// The last station: a clustered mesh as a file.
#pragma once

#include "io/byte_sink.hpp"
#include "io/job.hpp"
#include "run/output_mesh.hpp"
#include "write/mesh_encoder.hpp"

#include <cstdint>
#include <string>
#include <vector>

namespace winnow {

// How a mesh is going to be written. Notes where floats are too coarse for positions that were
// `exact`, doubles, or whole numbers for any. Throws Error(usage) where floats do not reach.
MeshShape shape_of(Job& job, const OutputMesh& mesh, const MeshEncoder& encoder, bool normals,
                   bool double_positions, bool exact, std::string comment);

// Whether positions are doubles where the input's are or are not.
bool writes_doubles(const Encoding& encoding, bool input);

// A vertex as it is written: with a normal as long as 1. Throws Error(bad_input) where it is not
// finite.
MeshVertex finished(const IndexedVertex& vertex);

// Numbers of the corners of `count` faces from `first` on.
std::vector<std::uint32_t> faces_of(const StoredMesh& mesh, std::uint64_t first, std::size_t count);

// Of an IndexedVertex each, and the numbers that the shape has.
FinishedVertices finished_vertices(const Spool& vertices, const Spool* attributes,
                                   const MeshShape& shape, std::uint64_t first, std::size_t count);

// Encodes with all threads, writes in order; does not finish() the sink.
void write_mesh(Job& job, const OutputMesh& mesh, const MeshShape& shape,
                const MeshEncoder& encoder, ByteSink& sink);

}  // namespace winnow
