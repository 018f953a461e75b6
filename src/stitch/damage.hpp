// Where a mesh is no surface: what clustering joined that did not belong together.
#pragma once

#include "cluster/clusterer.hpp"
#include "stitch/tile.hpp"

#include <cstdint>
#include <optional>
#include <vector>

namespace winnow {

// Faces that fell onto the same three cells are a fold where they hang together by their own edges,
// and where the faces around them close without them: as many of one sense as of the other go, one
// stays where one is left over. All others are damage, such as two walls that became one.
struct Damage {
  // Vertices whose faces, without folds, are not one fan, closed or open, of one sense; vertices of
  // faces that fell together and are no fold; and vertices with so many faces that no tile has them
  // all. Ascending.
  std::vector<std::uint32_t> vertices;
  std::vector<std::uint32_t> at_boundaries;  // whose fan is open; ascending
  std::vector<FaceVertices> folds;           // of which no face stays; ascending
  std::vector<std::uint32_t> folded;         // vertices that have no face but a fold; ascending
};

// `fused`: where given, the faces that several fell onto, a FusedFace each, in the order of faces.
// Nothing where more than `most` vertices are to be told, or more faces fell together. `reach`: a
// vertex farther from the edge that stays of its only fold is damaged. `memory`: for tiles at work,
// and as much again for sorting.
std::optional<Damage> find_damage(Job& job, const StoredMesh& whole, const Spool* fused,
                                  std::uint64_t most, double reach, std::uint64_t memory);

}  // namespace winnow
