// How what makes a progressive file divides the memory that it is given.
#pragma once

#include "base/memory_shares.hpp"

namespace winnow::share {

// A progressive file: refining it, and what goes.
namespace progressive {
inline constexpr Share refining{1, 2}, records{1, 4}, encoding{1, 4};
static_assert(fit(refining, records, encoding));
inline constexpr Share numbers{1, 4}, sorting{1, 4}, packed{1, 4};  // of encoding
static_assert(fit(numbers, sorting, packed));
}  // namespace progressive

// A level that is extracted.
namespace extracted {
inline constexpr Share pages{1, 4};  // of its mesh, where that is in scratch
}

}  // namespace winnow::share
