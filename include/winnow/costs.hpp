// What judges which edges are collapsed, and what each of these costs can do.
#pragma once

#include <winnow/values.hpp>

namespace winnow {

// What is made of the clustered mesh.
enum class Refine {
  none,       // nothing: pure clustering
  quadric,    // collapse edges at the least distance from the planes of the faces they stand for
  volume,     // collapse vertices that cover the least volume
  importance  // collapse what is seen least
};

struct CostFacts {
  const char* name = nullptr;
  bool bounds_error = false;  // it is a distance: goes with SimplifyOptions::error
};

constexpr CostFacts facts_of(Refine cost) {
  switch (cost) {
    case Refine::none:
      return {.name = "none"};
    case Refine::quadric:
      return {.name = "quadric", .bounds_error = true};
    case Refine::volume:
      return {.name = "volume"};
    case Refine::importance:
      return {.name = "importance"};
  }
  return {};
}

}  // namespace winnow
