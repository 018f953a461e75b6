// A contact sheet of a sequence: some of its frames beside each other, above as they were, below
// as they are simplified.
#pragma once

#include <winnow/compare.hpp>

#include "io/job.hpp"

#include <string>
#include <vector>

namespace winnow {

// Of `options` counts where the picture goes, and from where it is seen. All frames are seen by one
// camera. Needs an arena.
void write_frame_sheet(Job& job, const std::vector<std::string>& originals,
                       const std::vector<std::string>& simplified, const CompareOptions& options);

}  // namespace winnow
