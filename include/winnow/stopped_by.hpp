// What ended refinement.
#pragma once

#include <winnow/values.hpp>

namespace winnow {

// The target, or what kept the faces that are too many.
enum class StoppedBy {
  count,       // there are as few faces as were wanted
  error,       // there are as few as can be with the error wanted
  topology,    // fewer would change the topology or destroy the shape
  boundaries,  // Boundary::keep keeps their vertices
  hubs,        // vertices with very many faces stay
  pieces       // SimplifyOptions::keep_pieces keeps them
};

struct StopFacts {
  const char* name = nullptr;
};

constexpr StopFacts facts_of(StoppedBy reason) {
  switch (reason) {
    case StoppedBy::count:
      return {.name = "count"};
    case StoppedBy::error:
      return {.name = "error"};
    case StoppedBy::topology:
      return {.name = "topology"};
    case StoppedBy::boundaries:
      return {.name = "boundaries"};
    case StoppedBy::hubs:
      return {.name = "hubs"};
    case StoppedBy::pieces:
      return {.name = "pieces"};
  }
  return {};
}

}  // namespace winnow
