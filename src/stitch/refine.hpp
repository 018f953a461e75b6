// The second half of the pipeline: a clustered or welded mesh is made smaller by collapsing edges,
// tile by tile.
#pragma once

#include "io/checkpoint_directory.hpp"
#include "stitch/refine_report.hpp"
#include "stitch/refine_settings.hpp"
#include "stitch/tile.hpp"

namespace winnow {

struct Refined {
  StoredMesh mesh;
  RefineReport report;
};

// Never more faces than wanted, unless topology allows no fewer; at most one collapse less.
//
// With a checkpoint, every round and every tile that is done is kept in it, and at the end the
// result. Where it holds some already, `whole` has to be the mesh in it, and what is done is not
// done again; report.tiles_before says how much.
Refined refine(Job& job, StoredMesh whole, const RefineSettings& settings,
               const RefineMemory& memory, CheckpointDirectory* checkpoint = nullptr);

}  // namespace winnow
