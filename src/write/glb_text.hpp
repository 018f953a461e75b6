// Numbers in the JSON of a GLB.
#pragma once

#include "base/text.hpp"
#include "base/vector.hpp"

#include <cstdint>
#include <string>

namespace winnow {

inline std::string glb_number(std::uint64_t value) {
  return std::to_string(value);
}

inline std::string glb_list(const Point& values) {
  return "[" + shortest(values[0]) + "," + shortest(values[1]) + "," + shortest(values[2]) + "]";
}

}  // namespace winnow
