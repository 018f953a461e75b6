// What `winnow sequence` says when it is done, and `winnow resume` of a run of it.
#pragma once

#include <winnow/sequence.hpp>

#include "program.hpp"

namespace winnow::cli {

// The summary of a run, or its report as JSON, as the options ask for.
void tell(const SequenceReport& report, const CommonOptions& options);

}  // namespace winnow::cli
