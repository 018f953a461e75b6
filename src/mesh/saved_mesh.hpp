// A mesh between two rounds, in a checkpoint.
#pragma once

#include "io/checkpoint_directory.hpp"
#include "mesh/stored_mesh.hpp"

#include <cstdint>

namespace winnow {

// After so many rounds; in place of the mesh that was saved before, from the next commit() on. With
// `keep_first`, vertices and faces of the one before the first round stay, too.
void save_mesh(CheckpointDirectory& checkpoint, const StoredMesh& whole, std::uint64_t rounds,
               bool keep_first);

// Uses at most `memory` bytes of the budget.
StoredMesh load_mesh(Job& job, const CheckpointDirectory& checkpoint, std::uint64_t memory);

// Vertices and faces before the first round, likewise.
StoredMesh load_reference(Job& job, const CheckpointDirectory& checkpoint, std::uint64_t memory);

}  // namespace winnow
