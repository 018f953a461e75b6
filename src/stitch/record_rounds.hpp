// Refines a mesh down to a base, round by round, and writes down what goes.
#pragma once

#include "io/checkpoint_directory.hpp"
#include "progressive/recorded_rounds.hpp"
#include "progressive/vertex_words.hpp"
#include "stitch/refine_settings.hpp"
#include "stitch/tile.hpp"

#include <cstdint>

namespace winnow {

struct RecordedMesh {
  RecordedRounds rounds;
  // What is left. A vertex has its number in the whole mesh as IndexedVertex::unused, unless there
  // was no round: then they are the same.
  StoredMesh base;
  std::uint64_t round_count = 0;
  std::uint64_t collapses = 0;
  std::uint64_t rounds_before = 0, tiles_before = 0;  // that a checkpoint held
};

// Down to about settings.faces, unless topology allows no fewer. Every round takes half of the
// faces at one cost for all tiles; the last one, of a mesh of one tile, all that are left to take.
// `words` and `settings` must stay. `record_memory`: for what is written down.
//
// With a checkpoint, every round and every tile that was tried is kept in it. Where it holds some
// already, `whole` has to be the mesh in it, and what is done is not done again.
RecordedMesh record_rounds(Job& job, StoredMesh whole, RefineSettings settings,
                           const VertexWords& words, const RefineMemory& memory,
                           std::uint64_t record_memory, CheckpointDirectory* checkpoint = nullptr);

}  // namespace winnow
