// Where a mesh is no surface: what clustering joined that did not belong together.
#pragma once

#include "cluster/clusterer.hpp"
#include "stitch/tile.hpp"

#include <cstdint>
#include <optional>
#include <vector>

namespace winnow {

struct Damage {
  // Vertices whose faces are not one fan, closed or open, of one sense; ascending. Also those with so many
  // faces that no tile has them all.
  std::vector<std::uint32_t> vertices;
  std::vector<std::uint32_t> at_boundaries;  // whose fan is open; ascending
};

// Nothing where more than `most` vertices are to be told. `memory`: for tiles at work, and as much again for
// sorting.
std::optional<Damage> find_damage(Job& job, const RefinedMesh& whole, std::uint64_t most,
                                  std::uint64_t memory);

}  // namespace winnow
