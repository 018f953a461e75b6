#include "io/read_ahead.hpp"

#include <algorithm>

#include <fcntl.h>

namespace winnow {

void ReadAhead::ask(std::uint64_t begin, std::uint64_t end) {
  const std::uint64_t until = std::min(end + distance, end_);
  std::uint64_t asked = asked_.load(std::memory_order_relaxed);
  // Another thread that was first asks for the same.
  if (until <= asked || !asked_.compare_exchange_strong(asked, until, std::memory_order_relaxed))
    return;
  const std::uint64_t from = std::max(asked, begin);
  if (from < until)
    ::posix_fadvise(fd_, static_cast<off_t>(from), static_cast<off_t>(until - from),
                    POSIX_FADV_WILLNEED);
}

}  // namespace winnow
