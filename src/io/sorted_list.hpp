// Records that are sorted in memory while they fit, and written to runs when they do not.
#pragma once

#include "base/growing_pages.hpp"
#include "io/sorted_runs.hpp"

#include <algorithm>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

namespace winnow {

// Filled by one thread; several lists, one a thread, share `runs`. Records that Record::combine
// allows to be added up become one.
template <typename Record>
class SortedList {
 public:
  // Takes at most `memory` bytes, which the caller has reserved.
  SortedList(Job& job, std::uint64_t memory, SortedRuns<Record>& runs)
      : job_(job), budget_(memory), pages_(budget_, memory), runs_(runs) {}

  void add(const Record& record) {
    if ((count_ + 1) * sizeof(Record) > pages_.usable() &&
        !pages_.grow_to((count_ + 1) * sizeof(Record)))
      make_room();
    reinterpret_cast<Record*>(pages_.data())[count_++] = record;
  }

  // To be called before finish(), when nothing is added any more; apart, so that lists can be
  // sorted at once.
  void sort() {
    const std::span<Record> all = records();
    std::sort(all.begin(), all.end(), job_.progress.cancellable(Before<Record>()));
    std::size_t kept = 0;
    for (const Record& record : all) {
      if (kept > 0 && !Record::before(all[kept - 1], record) &&
          Record::combine(all[kept - 1], record))
        continue;
      all[kept++] = record;
    }
    count_ = kept;
  }

  // What is in memory as a cursor.
  void finish(std::vector<std::unique_ptr<RecordCursor<Record>>>& sources) {
    if (count_ > 0) sources.push_back(std::make_unique<MemoryCursor<Record>>(records()));
  }

 private:
  [[nodiscard]] std::span<Record> records() const {
    return {reinterpret_cast<Record*>(pages_.data()), count_};
  }

  void make_room() {
    sort();
    // Where most records were repeats there is room again without writing.
    if (count_ * sizeof(Record) <= pages_.usable() / 4) return;
    MemoryCursor<Record> all(records());
    runs_.add(all);
    count_ = 0;
  }

  Job& job_;
  Budget budget_;
  GrowingPages pages_;
  SortedRuns<Record>& runs_;
  std::size_t count_ = 0;
};

// All records of some lists and their runs, in order.
template <typename Record>
MergedCursor<Record> merge(const std::vector<SortedList<Record>*>& lists,
                           const SortedRuns<Record>& runs) {
  std::vector<std::unique_ptr<RecordCursor<Record>>> sources;
  for (SortedList<Record>* list : lists) list->finish(sources);
  runs.add_cursors(sources);
  return MergedCursor<Record>(std::move(sources));
}

}  // namespace winnow
