// Refines a mesh down to a base, round by round, and writes down what goes.
#pragma once

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
};

// Down to about settings.faces, unless topology allows no fewer. Every round takes half of the
// faces at one cost for all tiles; the last one, of a mesh of one tile, all that are left to take.
// `words` and `settings` must stay. `record_memory`: for what is written down.
RecordedMesh record_rounds(Job& job, StoredMesh whole, RefineSettings settings,
                           const VertexWords& words, const RefineMemory& memory,
                           std::uint64_t record_memory);

}  // namespace winnow
