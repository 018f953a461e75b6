// What rounds took away as the chunks of a progressive file.
#pragma once

#include "mesh/stored_mesh.hpp"
#include "progressive/file_header.hpp"
#include "progressive/recorded_rounds.hpp"
#include "progressive/vertex_words.hpp"

#include <cstdint>
#include <vector>

namespace winnow {

struct EncodedRounds {
  Spool bytes;  // of all chunks, one after the other
  std::vector<ChunkEntry> chunks;
  std::uint32_t base_chunks = 0;
};

// `base`: what is left, whose vertices have their numbers of the whole mesh as
// IndexedVertex::unused, unless `numbered` is false: then they are the same. `vertices`: of the
// whole mesh. Within `memory`, and some for each thread.
EncodedRounds encode_rounds(Job& job, const RecordedRounds& rounds, const StoredMesh& base,
                            bool numbered, std::uint64_t vertices, const VertexWords& words,
                            std::uint64_t memory);

}  // namespace winnow
