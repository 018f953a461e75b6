// The one hook that lets the library map input files safely.
#pragma once

#include <winnow/api.hpp>

namespace winnow {

// Installs a SIGBUS handler for the whole process, so that an input file which another program
// shortens while it is mapped ends in Error(bad_input) instead of the death of the process. A
// SIGBUS that does not come from a file which winnow mapped goes to the handler that was there
// before. Call it once, from a program's main, before any call with Context::map_input = true.
// Calling it again does nothing. Throws Error(failed) if the system refuses.
WINNOW_API void guard_mapped_files();

}  // namespace winnow
