// What a checkpoint keeps of a sequence besides what all runs have.
#pragma once

#include "base/morph_clip.hpp"
#include "run/read_sequence.hpp"
#include "run/run_checkpoint.hpp"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace winnow {

// Where something is kept. `clips`: how the input plays.
void save(Job& job, RunCheckpoint& checkpoint, ReadSequence& read,
          const std::vector<MorphClip>& clips);
// `frames`: memory for the frames as they were read, `mesh`: for the mesh of them. What the report
// tells of the sequence is only there.
ReadSequence load_sequence(Job& job, const RunCheckpoint& checkpoint, std::uint64_t frames,
                           std::uint64_t mesh);

// Of a run that has its mesh.
std::size_t frames_in(const CheckpointDirectory& directory);
std::vector<MorphClip> load_clips(Job& job, const CheckpointDirectory& directory);

}  // namespace winnow
