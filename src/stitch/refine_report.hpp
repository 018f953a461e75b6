// What refinement tells of itself.
#pragma once

#include <winnow/stopped_by.hpp>

#include "decimate/collapser.hpp"

#include <cstdint>
#include <vector>

namespace winnow {

// Faces that are left where the count was missed, by what keeps them: `topology` are those of no
// other kind.
struct BlockedFaces {
  std::uint64_t topology = 0;
  std::uint64_t boundaries = 0;  // at vertices that DecimationSettings::keep_boundaries keeps
  std::uint64_t hubs = 0;        // at hubs
  std::uint64_t pieces = 0;      // of small pieces that DecimationSettings::keep_pieces keeps

  void add(const BlockedFaces& more) {
    topology += more.topology;
    boundaries += more.boundaries;
    hubs += more.hubs;
    pieces += more.pieces;
  }
  // What keeps one face in eight or more, what keeps most of them first.
  [[nodiscard]] std::vector<StoppedBy> reasons() const;
};

struct RefineReport {
  std::uint64_t tiles = 0;  // of the first round
  std::uint64_t rounds = 0;
  std::uint64_t collapses = 0;
  double largest_error = 0;  // of a vertex from its planes, in the mean; model units
  StoppedBy stopped_by =
      StoppedBy::count;  // the first of blocked.reasons() where the count was missed
  BlockedFaces blocked;
  TopologyChanges changes;
  std::uint64_t joined = 0;  // vertices that went by join_vertices.hpp
  // What a checkpoint held: rounds that were done, and tiles of the next.
  std::uint64_t rounds_before = 0, tiles_before = 0;
};

}  // namespace winnow
