// All cells met so far, inside the budget; what does not fit goes to scratch, sorted.
#pragma once

#include "base/pages.hpp"
#include "cluster/attribute_sum.hpp"
#include "cluster/cell_sum.hpp"
#include "io/job.hpp"
#include "io/sorted_runs.hpp"

#include <atomic>
#include <cstdint>
#include <memory>
#include <mutex>
#include <span>
#include <vector>

namespace winnow {

// A hash table in parts, each with a lock of its own; open addressing, one cache line (or two) an
// entry.
template <typename Sum>
class CellTable {
 public:
  CellTable(Job& job, std::uint64_t memory, std::size_t parts);

  // Adds entries keyed by Morton key; from any thread. The caller's entries are reordered.
  void add(std::span<Sum> entries);

  // Whether it is time for spill(): a little before there is no other way.
  [[nodiscard]] bool nearly_full() const { return nearly_full_.load(std::memory_order_relaxed); }

  // Writes everything to scratch as one sorted run. While no add() is running.
  void spill();

  // All cells in key order, in memory and in scratch, when nothing is added any more. A cell can
  // come more than once, one after the other.
  std::unique_ptr<RecordCursor<Sum>> finish();

  void release();  // all memory, when the cursor of finish() is gone

  [[nodiscard]] bool spilled() const { return !runs_.empty(); }

 private:
  struct Part {
    std::mutex mutex;
    Pages memory;
    std::size_t capacity = 0;
    std::size_t count = 0;
    std::vector<Sum> overflow;  // full sums; their cells go on from zero in the table
  };

  void add_to(Part& part, const Sum& entry);
  Sum& slot(Part& part, CellKey key) const;
  bool grow(Part& part);
  void spill_locked();
  std::vector<std::unique_ptr<RecordCursor<Sum>>> sort_parts();

  Job& job_;
  Budget budget_;
  std::vector<Part> parts_;
  std::atomic<bool> nearly_full_{false};
  SortedRuns<Sum> runs_;
};

extern template class CellTable<CellSum>;
extern template class CellTable<QuadricCellSum>;
extern template class CellTable<AttributeSum<4>>;
extern template class CellTable<AttributeSum<8>>;
extern template class CellTable<AttributeSum<16>>;

}  // namespace winnow
