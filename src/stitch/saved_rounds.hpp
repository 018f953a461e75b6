// What the rounds so far have left beside the mesh, in a checkpoint.
#pragma once

#include "io/checkpoint_directory.hpp"
#include "stitch/choose_collapses.hpp"
#include "stitch/refine_report.hpp"

namespace winnow {

struct RoundsState {
  RefineReport report;
  KnownPrices prices;
  unsigned idle = 0;  // rounds that hardly helped
  bool done = false;  // there is no other round
};

// Counts from the next commit() on.
void save_rounds(Manifest& manifest, const RoundsState& state);

bool holds_rounds(const Manifest& manifest);
RoundsState load_rounds(const Manifest& manifest);

}  // namespace winnow
