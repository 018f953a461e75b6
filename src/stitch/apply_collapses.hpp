// What is left of a mesh when its tiles have been collapsed.
#pragma once

#include "stitch/choose_collapses.hpp"
#include "stitch/tiles.hpp"

#include <cstdint>

namespace winnow {

struct CollapsedMesh {
  StoredMesh whole;
  std::uint64_t collapses = 0;
  double largest_error = 0;
  TopologyChanges changes;
};

// Nothing goes but vertices without a face; the others get their normals.
CollapsedMesh collapse_nothing(const Tiles& tiles);

// Each tile collapses what it can, in the order of costs up to the costliest: down to the count
// where it is the only one.
CollapsedMesh collapse_all(const Tiles& tiles, std::uint64_t round, double costliest);

// The collapses that were chosen are repeated.
CollapsedMesh collapse_chosen(const Tiles& tiles, const ChosenCollapses& chosen);

}  // namespace winnow
