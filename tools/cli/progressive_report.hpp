// What `winnow progressive` says when it is done, and `winnow resume` of a run of it.
#pragma once

#include <winnow/progressive.hpp>

#include "program.hpp"

namespace winnow::cli {

// The summary of a run, or its report as JSON, as the options ask for.
void tell(const ProgressiveReport& report, const CommonOptions& options);

}  // namespace winnow::cli
