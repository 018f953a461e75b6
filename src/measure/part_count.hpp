// How many connected parts a stream of faces has.
#pragma once

#include "base/pages.hpp"
#include "base/per_slot.hpp"
#include "cluster/components.hpp"
#include "io/job.hpp"

#include <array>
#include <atomic>
#include <cstdint>
#include <memory>
#include <optional>
#include <shared_mutex>
#include <span>

namespace winnow {

// Positions are named by 64-bit hashes; faces hang together where they share one. A table joins
// them as they come. When it is full, each position is linked to one of those that it hangs
// together with so far, the table is emptied, and in the end the links are joined by sorting.
class PartCount {
 public:
  // `positions`: how many there are at the most, where that is known.
  PartCount(Job& job, std::uint64_t memory, std::optional<std::uint64_t> positions);

  void add(std::span<const std::array<std::uint64_t, 3>>
               faces);  // from any thread; at most `most_at_once`
  static constexpr std::size_t most_at_once = 128;

  // The last call. A face whose corners are all in one place is no part.
  std::uint64_t finish();

 private:
  using Slot = std::uint32_t;

  // Where the positions of the last faces are in the table.
  struct Recent {
    static constexpr unsigned bits = 12;
    std::array<std::uint64_t, 1U << bits> key{};
    std::array<Slot, 1U << bits> slot{};
    std::uint64_t emptied = 0;  // the table, when this was written
  };

  Slot slot_of(std::uint64_t key, Recent& recent, std::uint64_t& fresh);
  Slot root(Slot slot);
  void join(Slot one, Slot other);
  void empty_table();

  Job& job_;
  std::uint64_t link_memory_;
  Pages pages_;
  std::span<std::atomic<std::uint64_t>> keys_;  // 0: a free slot
  std::span<std::atomic<Slot>> parents_;        // one more than the slot's parent; 0: it has none
  std::uint64_t full_;                          // so many positions are enough for the table
  std::shared_mutex emptying_;
  std::atomic<std::uint64_t> used_{0};
  std::uint64_t emptied_ = 0;  // times the table was
  PerSlot<Recent> recent_;
  std::unique_ptr<Components> links_;  // since it was first full
};

}  // namespace winnow
