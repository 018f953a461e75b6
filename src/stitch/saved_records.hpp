// What the rounds of a progressive file have left beside the mesh, in a checkpoint.
#pragma once

#include "io/checkpoint_directory.hpp"
#include "progressive/recorded_rounds.hpp"

#include <cstdint>

namespace winnow {

struct RecordState {
  std::uint64_t collapses = 0;
  unsigned idle = 0;  // rounds that hardly helped
  bool done = false;  // there is no other round
};

// After so many rounds, of which `last` is the last. Counts from the next commit() on.
void save_record(Job& job, CheckpointDirectory& checkpoint, std::uint64_t rounds,
                 const RecordedRound& last, const RecordState& state);

// Rounds that the checkpoint holds.
std::uint64_t saved_records(const CheckpointDirectory& checkpoint);
RecordState load_record_state(const CheckpointDirectory& checkpoint);
// One of them, from 1 on. Uses at most `memory` bytes of the budget.
RecordedRound load_record(const CheckpointDirectory& checkpoint, std::uint64_t round,
                          std::uint64_t memory);

}  // namespace winnow
