// The second half of the road, as the options ask for it.
#pragma once

#include <winnow/simplify.hpp>

#include "cluster/clusterer.hpp"
#include "io/checkpoint_directory.hpp"
#include "io/job.hpp"
#include "run/clustering.hpp"
#include "stitch/refine.hpp"

#include <cstdint>

namespace winnow {

// In eighths of what clustering left: four for tiles, two for the mesh that comes out, one each for what was
// collapsed and for sorting.
RefineMemory refine_memory(std::uint64_t left);

// `doubles`: positions are going to be written as such. Fills report.refine, and what was resumed.
// `checkpoint`: null where nothing is kept.
ClusteredMesh refined(Job& job, Clustered clustered, const SimplifyOptions& options, bool doubles,
                      CheckpointDirectory* checkpoint, SimplifyReport& report);

}  // namespace winnow
