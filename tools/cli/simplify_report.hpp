// What `winnow simplify` and `winnow resume` say when they are done, and --dry-run before.
#pragma once

#include "program.hpp"

#include <string>
#include <vector>

namespace winnow::cli {

const char* name_of(Refine refine);

// The summary of a run, or its report as JSON, as the options ask for.
void tell(const SimplifyReport& report, const CommonOptions& options);
void tell(const SimplifyPlan& plan, const std::vector<std::string>& inputs,
          const std::string& output, const CommonOptions& options);

}  // namespace winnow::cli
