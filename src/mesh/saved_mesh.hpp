// A mesh between two rounds, in a checkpoint.
#pragma once

#include "io/checkpoint_directory.hpp"
#include "mesh/stored_mesh.hpp"

#include <cstddef>
#include <cstdint>

namespace winnow {

// After so many rounds; in place of the mesh that was saved before, from the next commit() on. With
// `keep_first`, vertices and faces of the one before the first round stay, too. What was kept as a
// level stays, but for what collapsing has to know.
void save_mesh(CheckpointDirectory& checkpoint, const StoredMesh& whole, std::uint64_t rounds,
               bool keep_first);

// The mesh that was saved last is the result of this level.
void keep_level(CheckpointDirectory& checkpoint, std::size_t level);

// Without what collapsing has to know; uses at most `memory` bytes of the budget.
StoredMesh load_level(Job& job, const CheckpointDirectory& checkpoint, std::size_t level,
                      std::uint64_t memory);

// Uses at most `memory` bytes of the budget.
StoredMesh load_mesh(Job& job, const CheckpointDirectory& checkpoint, std::uint64_t memory);

// Vertices and faces before the first round, likewise.
StoredMesh load_reference(Job& job, const CheckpointDirectory& checkpoint, std::uint64_t memory);

}  // namespace winnow
