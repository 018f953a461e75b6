// The second half of the road, as the options ask for it.
#pragma once

#include <winnow/simplify.hpp>

#include "cluster/clusterer.hpp"
#include "io/job.hpp"
#include "run/clustering.hpp"

namespace winnow {

// Fills report.refine. `single`: positions are floats. `attributes`: how many numbers vertices carry.
ClusteredMesh refined(Job& job, ClusteredMesh mesh, const SimplifyOptions& options,
                      const Clustering& clustering, bool single, std::size_t attributes,
                      SimplifyReport& report);

}  // namespace winnow
