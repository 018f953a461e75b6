// The first half of a run: its input is read, welded where that is asked for, and clustered.
#pragma once

#include <winnow/simplify.hpp>

#include "base/progress.hpp"
#include "run/clustering.hpp"
#include "run/input.hpp"
#include "run/plan.hpp"

namespace winnow {

// `wish`: attributes to carry. `map`: whether it tells where vertices went. `watch`: runs since the
// run began. Its report tells of the input, what was welded, and the time so far.
Clustered cluster_input(Job& job, Input& input, const SimplifyOptions& options,
                        const AttributeRequest& wish, bool map, const MemoryPlan& plan,
                        const Stopwatch& watch);

}  // namespace winnow
