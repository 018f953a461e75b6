// Records sorted within a reserved share of the budget, and in scratch beyond it.
#pragma once

#include "base/parallel.hpp"
#include "base/per_slot.hpp"
#include "io/sorted_list.hpp"

#include <cstdint>
#include <memory>
#include <vector>

namespace winnow {

// Filled by one thread.
template <typename Record>
class SortedRecords {
 public:
  static constexpr std::uint64_t least_memory = std::uint64_t{1} << 16;

  SortedRecords(Job& job, std::uint64_t memory)
      : reserved_(job.budget.reserve(memory, "sorting")), runs_(job), list_(job, memory, runs_) {}

  void add(const Record& record) { list_.add(record); }

  // When all are added. The cursor reads from this object.
  MergedCursor<Record> merged() {
    list_.sort();
    return merge(std::vector<SortedList<Record>*>{&list_}, runs_);
  }

 private:
  Reservation reserved_;
  SortedRuns<Record> runs_;
  SortedList<Record> list_;
};

// Filled by all threads of the job's arena, each its own list.
template <typename Record>
class ThreadedRecords {
 public:
  ThreadedRecords(Job& job, std::uint64_t memory)
      : reserved_(job.budget.reserve(memory, "sorting")),
        runs_(job),
        lists_(job.threads, [this, &job, memory] {
          return std::make_unique<SortedList<Record>>(job, memory / job.threads, runs_);
        }) {}

  SortedList<Record>& local() { return lists_.local(); }

  MergedCursor<Record> merged() {
    const std::vector<SortedList<Record>*> all = lists_.all();
    parallel_for(all.size(), [&all](std::size_t i) { all[i]->sort(); });
    return merge(all, runs_);
  }

 private:
  Reservation reserved_;
  SortedRuns<Record> runs_;
  PerSlot<SortedList<Record>> lists_;
};

}  // namespace winnow
