// Which side is left of a surface that is given in both senses.
#pragma once

#include "mesh/stored_mesh.hpp"

#include <cstdint>

namespace winnow {

// A face that stood as often in one sense as in the other. The mesh has it in that of its first.
struct TwoSidedFace {
  std::uint64_t place;  // among the faces of the mesh
  std::uint32_t first;  // number of its first in the input, the low 32 bits
};

// Turns such faces until they agree across edges of two faces: with the faces beside them that
// stood in one sense, else with the first of them in the input. `faces`: a TwoSidedFace each, in
// the order of places. Where no side agrees, as on a Möbius strip, each stays as it is. Sorts
// within `memory`.
void agree_on_sides(Job& job, const Spool& faces, std::uint64_t memory, StoredMesh& mesh);

}  // namespace winnow
