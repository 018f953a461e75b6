// The threads of one run.
#pragma once

#include "io/job.hpp"

#include <optional>
#include <utility>

#include <tbb/global_control.h>
#include <tbb/task_arena.h>

namespace winnow {

// Runs `work` with as many threads as the job allows, the calling one among them.
template <typename Work>
auto in_arena(Job& job, Work&& work) {
  constexpr auto parallelism = tbb::global_control::max_allowed_parallelism;
  // The arena is the limit. The process may get more threads, but not fewer: the caller's own work
  // needs them.
  std::optional<tbb::global_control> more;
  if (job.threads > tbb::global_control::active_value(parallelism))
    more.emplace(parallelism, job.threads);
  tbb::task_arena arena(static_cast<int>(job.threads));
  return arena.execute(std::forward<Work>(work));
}

}  // namespace winnow
