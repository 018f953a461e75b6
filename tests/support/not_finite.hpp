// Numbers that no place and no attribute should have.
#pragma once

#include <limits>

namespace winnow::test {

inline constexpr double infinity = std::numeric_limits<double>::infinity();
inline constexpr double nan = std::numeric_limits<double>::quiet_NaN();

}  // namespace winnow::test
