// What all rounds of a refinement took away, in memory or in scratch.
#pragma once

#include "io/job.hpp"
#include "io/spool.hpp"
#include "io/spool_records.hpp"
#include "progressive/split.hpp"

#include <algorithm>
#include <cstdint>
#include <vector>

namespace winnow {

// Collapses of one tile, one after the other, that become one chunk of the file.
struct RecordedPart {
  std::uint32_t band = 0;  // how costly they are: parts of the costliest come first in the file
  std::uint32_t splits = 0, vertices = 0, faces = 0;
  std::uint64_t first_word = 0, words = 0;  // in RecordedRounds::words
  std::uint64_t first_gone = 0;             // in RecordedRounds::gone
};

// Filled tile by tile and round by round, by one thread; after finish() read by any.
class RecordedRounds {
 public:
  RecordedRounds(Job& job, std::uint64_t memory)
      : words_(job, memory - memory / 16), gone_(job, memory / 16) {}

  // Of the next tile of a round: its parts in the order in which they were collapsed, with places
  // among these words and vertices.
  void append(std::vector<RecordedPart> parts, const Words& words,
              const std::vector<std::uint32_t>& gone) {
    for (RecordedPart& part : parts) {
      part.first_word += record_count<std::uint32_t>(words_);
      part.first_gone += record_count<std::uint32_t>(gone_);
    }
    // Of a tile what was collapsed last comes back first.
    round_.insert(round_.end(), parts.rbegin(), parts.rend());
    append_records<std::uint32_t>(words_, words);
    append_records<std::uint32_t>(gone_, gone);
  }
  void finish_round() {
    std::stable_sort(round_.begin(), round_.end(),
                     [](const auto& a, const auto& b) { return a.band > b.band; });
    parts_.insert(parts_.begin(), round_.begin(), round_.end());
    round_.clear();
  }
  void finish() {
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
  std::vector<RecordedPart> parts_, round_;
};

}  // namespace winnow
