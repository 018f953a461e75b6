// How far one level is refined, of several that are made one after the other.
#pragma once

#include <cstdint>

namespace winnow {

struct LevelGoal {
  std::uint64_t faces = 0;  // wanted; 0: as few as there can be
  double error = 0;         // that is watched, in model units; 0: none
};

}  // namespace winnow
