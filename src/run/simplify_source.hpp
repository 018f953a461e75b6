// The pipeline from an open input to an open output, whatever these are: read, cluster, refine,
// write.
#pragma once

#include <winnow/simplify.hpp>

#include "io/job.hpp"
#include "run/input.hpp"
#include "run/outputs.hpp"

namespace winnow {

// Before an output is opened: what the rest of the budget has to be.
void expect_plan(Job& job, const SimplifyOptions& options);

// Inside the job's arena. `watch` began with the call.
SimplifyReport simplify_input(Job& job, Input input, const Outputs& outputs,
                              const SimplifyOptions& options, const Stopwatch& watch);

}  // namespace winnow
