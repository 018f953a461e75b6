// What the system says of this process and of this machine.
#pragma once

#include <cstdint>

namespace winnow {

std::uint64_t
peak_resident_bytes();  // largest resident set so far; 0 where the system does not tell
unsigned processors();  // processors this process may run on; at least 1

}  // namespace winnow
