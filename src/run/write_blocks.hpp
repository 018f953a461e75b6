// A mesh as a file of a format that is made of blocks, each with its own vertices.
#pragma once

#include "io/byte_sink.hpp"
#include "io/job.hpp"
#include "mesh/stored_mesh.hpp"
#include "write/mesh_encoder.hpp"

namespace winnow {

// Room for one block, held from before the plan is made until all is written, so that too small a
// budget is refused at once. Nothing where the encoder has no blocks. `attributes`: vertices may
// carry some.
Reservation reserve_block(Job& job, const MeshEncoder& encoder, bool attributes = false);

// Faces keep their order but within a block; a vertex is in every block that has a face of it, the
// same to the bit. Blocks wait in memory or scratch until all sizes are known; does not finish()
// the sink. The caller holds reserve_block().
void write_blocks(Job& job, const StoredMesh& mesh, const MeshShape& shape,
                  const BlockEncoder& encoder, ByteSink& sink);

}  // namespace winnow
