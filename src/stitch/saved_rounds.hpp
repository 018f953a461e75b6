// What the rounds so far have left beside the mesh, in a checkpoint.
#pragma once

#include "io/checkpoint_directory.hpp"
#include "stitch/choose_collapses.hpp"
#include "stitch/refine_report.hpp"

namespace winnow {

struct RoundsState {
  RefineReport report;
  KnownCosts costs;
  unsigned idle = 0;  // rounds that hardly helped
  bool done = false;  // there is no other round
  std::size_t level = 0;
  std::uint64_t stage = 0;      // rounds of all levels
  std::uint64_t collapses = 0;  // of the levels before

  void next_level();
};

// Counts from the next commit() on.
void save_rounds(Manifest& manifest, const RoundsState& state);

bool holds_rounds(const Manifest& manifest);
RoundsState load_rounds(const Manifest& manifest);

// Of a level that was done before the one at work.
RefineReport load_level_report(const Manifest& manifest, std::size_t level);

}  // namespace winnow
