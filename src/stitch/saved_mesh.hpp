// A mesh between two rounds, in a checkpoint.
#pragma once

#include "io/checkpoint_directory.hpp"
#include "stitch/tile.hpp"

#include <cstdint>

namespace winnow {

// After so many rounds; in place of the mesh that was saved before, from the next commit() on.
void save_mesh(CheckpointDirectory& checkpoint, const RefinedMesh& whole, std::uint64_t rounds);

// Uses at most `memory` bytes of the budget.
RefinedMesh load_mesh(Job& job, const CheckpointDirectory& checkpoint, std::uint64_t memory);

}  // namespace winnow
