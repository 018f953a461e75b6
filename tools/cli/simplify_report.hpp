// What `winnow simplify` and `winnow resume` say when they are done, and --dry-run before.
#pragma once

#include "program.hpp"

namespace winnow::cli {

// The summary of a run, or its report as JSON, as the options ask for.
void tell(const SimplifyReport& report, const CommonOptions& options);
void tell(const SimplifyPlan& plan, const CommonOptions& options);

}  // namespace winnow::cli
