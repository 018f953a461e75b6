// What all rounds of a refinement took away, in memory or in scratch.
#pragma once

#include "io/job.hpp"
#include "io/spool.hpp"
#include "io/spool_records.hpp"
#include "progressive/split.hpp"

#include <algorithm>
#include <cstdint>
#include <utility>
#include <vector>

namespace winnow {

// Collapses of one tile, one after the other, that become one chunk of the file.
struct RecordedPart {
  std::uint32_t band = 0;  // how costly they are: parts of the costliest come first in the file
  std::uint32_t splits = 0, vertices = 0, faces = 0;
  double error = 0;  // within which each of them keeps the surface and all that it was
  std::uint64_t first_word = 0, words = 0;  // in RecordedRound::words
  std::uint64_t first_gone = 0;             // in RecordedRound::gone
};

// Filled tile by tile by one thread; after finish() read by any.
class RecordedRound {
 public:
  RecordedRound(Job& job, std::uint64_t memory)
      : words_(job, memory - memory / 16), gone_(job, memory / 16) {}
  // What a checkpoint kept of one.
  RecordedRound(Spool words, Spool gone, std::vector<RecordedPart> parts)
      : words_(std::move(words)), gone_(std::move(gone)), parts_(std::move(parts)) {}

  // Of the next tile: its parts in the order in which they were collapsed, with places among these
  // words and vertices.
  void append(std::vector<RecordedPart> parts, const Words& words,
              const std::vector<std::uint32_t>& gone) {
    for (RecordedPart& part : parts) {
      part.first_word += record_count<std::uint32_t>(words_);
      part.first_gone += record_count<std::uint32_t>(gone_);
    }
    // Of a tile what was collapsed last comes back first.
    parts_.insert(parts_.end(), parts.rbegin(), parts.rend());
    append_records<std::uint32_t>(words_, words);
    append_records<std::uint32_t>(gone_, gone);
  }
  void finish() {
    std::stable_sort(parts_.begin(), parts_.end(),
                     [](const auto& a, const auto& b) { return a.band > b.band; });
    words_.finish();
    gone_.finish();
  }

  // In the order of the file, coarse to fine.
  [[nodiscard]] const std::vector<RecordedPart>& parts() const { return parts_; }
  [[nodiscard]] const Spool& words() const { return words_; }
  // Vertices, in the order in which they went.
  [[nodiscard]] const Spool& gone() const { return gone_; }

 private:
  Spool words_, gone_;
  std::vector<RecordedPart> parts_;
};

// In the order in which they were made, fine to coarse.
using RecordedRounds = std::vector<RecordedRound>;

// In the order of the file: each(round, part).
template <typename Each>
void for_each_part(const RecordedRounds& rounds, const Each& each) {
  for (auto round = rounds.rbegin(); round != rounds.rend(); ++round) {
    for (const RecordedPart& part : round->parts()) each(*round, part);
  }
}

}  // namespace winnow
