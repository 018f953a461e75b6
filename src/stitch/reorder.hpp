// The same mesh with its vertices in the order of a shifted lattice: tiles then have other borders.
#pragma once

#include "stitch/tile.hpp"

namespace winnow {

// Shifts the keys by a third of the lattice, or back. That puts the borders of tiles of every size
// a third of a tile away from where they were, as a third is never near a sum of powers of one
// half. What is shifted out of the lattice comes in again on the other side, where it is as good as
// anywhere.
StoredMesh reorder(Job& job, StoredMesh whole, bool back, std::uint64_t list_memory,
                   std::uint64_t mesh_memory);

}  // namespace winnow
