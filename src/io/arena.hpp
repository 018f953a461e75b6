// The threads of one run.
#pragma once

#include "io/job.hpp"

#include <utility>

#include <tbb/global_control.h>
#include <tbb/task_arena.h>

namespace winnow {

// Runs `work` with as many threads as the job allows, the calling one among them.
template <typename Work>
auto in_arena(Job& job, Work&& work) {
  const tbb::global_control at_most(tbb::global_control::max_allowed_parallelism, job.threads);
  tbb::task_arena arena(static_cast<int>(job.threads));
  return arena.execute(std::forward<Work>(work));
}

}  // namespace winnow
