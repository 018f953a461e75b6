// What every report says at its end.
#pragma once

#include "base/process.hpp"
#include "base/progress.hpp"
#include "io/job.hpp"

namespace winnow {

// What the job used until now, and its notes. The time that went into no other stage went into
// writing.
template <typename Report>
void take_usage(const Job& job, const Stopwatch& watch, Report& report) {
  report.spilled_bytes = job.scratch.written();
  report.peak_scratch_bytes = job.scratch.peak();
  report.peak_memory_bytes = peak_resident_bytes();
  report.seconds.total = watch.seconds();
  report.seconds.write = report.seconds.total - report.seconds.read;
  if constexpr (requires { report.seconds.refine; }) report.seconds.write -= report.seconds.refine;
  report.notes = job.notes;
}

}  // namespace winnow
