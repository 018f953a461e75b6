// What a call says that was given no target, or several.
#pragma once

#include <winnow/error.hpp>

namespace winnow {

// Throws Error(usage).
[[noreturn]] inline void refuse_targets() {
  throw Error(ErrorKind::usage,
              "say how fine the result shall be with exactly one of `faces`, `ratio`, `error`, "
              "`cell` and `grid`");
}

}  // namespace winnow
