// The first half of a sequence's pipeline: all frames as one mesh.
#pragma once

#include <winnow/sequence.hpp>

#include "io/job.hpp"
#include "run/plan.hpp"
#include "sequence/frame_intake.hpp"
#include "sequence/frame_readers.hpp"

#include <cstdint>

namespace winnow {

struct ReadSequence {
  SequenceMesh sequence;
  std::uint64_t faces = 0;  // that refinement goes down to
  SequenceReport report{};  // of the input, and the target
};

// Throws Error(bad_input) where no face is left; Error(resources), naming a budget that is enough,
// where one frame does not fit into memory.
ReadSequence read_sequence(Job& job, FrameReaders& readers, const MemoryPlan& plan,
                           const SequenceOptions& options);

}  // namespace winnow
