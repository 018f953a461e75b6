// The second half of the road, as the options ask for it.
#pragma once

#include <winnow/simplify.hpp>

#include "cluster/clusterer.hpp"
#include "io/checkpoint_directory.hpp"
#include "io/job.hpp"
#include "run/clustering.hpp"

namespace winnow {

// `doubles`: positions are going to be written as such. Fills report.refine, and what was resumed.
// `checkpoint`: null where nothing is kept.
ClusteredMesh refined(Job& job, Clustered clustered, const SimplifyOptions& options, bool doubles,
                      CheckpointDirectory* checkpoint, SimplifyReport& report);

}  // namespace winnow
