// Records in sorted order, in memory and in scratch, and their merging.
#pragma once

#include "io/packed_blocks.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstring>
#include <memory>
#include <mutex>
#include <span>
#include <vector>

namespace winnow {

// Record::before as an object: a pointer to it would not be inlined into sorting.
template <typename Record>
struct Before {
  bool operator()(const Record& a, const Record& b) const { return Record::before(a, b); }
};

// Gives records in ascending order.
template <typename Record>
class RecordCursor {
 public:
  virtual ~RecordCursor() = default;
  virtual bool next(Record& record) = 0;  // false at the end
};

template <typename Record>
class MemoryCursor final : public RecordCursor<Record> {
 public:
  explicit MemoryCursor(std::span<const Record> records) : records_(records) {}

  bool next(Record& record) override {
    if (at_ == records_.size()) return false;
    record = records_[at_++];
    return true;
  }

 private:
  std::span<const Record> records_;
  std::size_t at_ = 0;
};

template <typename Record>
class RunCursor final : public RecordCursor<Record> {
 public:
  explicit RunCursor(const PackedFile& file) : reader_(file) {}

  bool next(Record& record) override {
    if (at_ == block_.size() && !refill()) return false;
    std::memcpy(&record, block_.data() + at_, sizeof record);
    at_ += sizeof record;
    return true;
  }

 private:
  bool refill() {
    at_ = 0;
    return reader_.next(block_);
  }

  PackedReader reader_;
  std::vector<std::byte> block_;
  std::size_t at_ = 0;
};

// Many cursors as one. Records that `Record::combine` allows to be added up come out as one.
template <typename Record>
class MergedCursor final : public RecordCursor<Record> {
 public:
  explicit MergedCursor(std::vector<std::unique_ptr<RecordCursor<Record>>> sources)
      : sources_(std::move(sources)), heads_(sources_.size()) {
    for (std::size_t i = 0; i < sources_.size(); ++i) {
      if (sources_[i]->next(heads_[i])) heap_.push_back(i);
    }
    for (std::size_t i = heap_.size() / 2; i-- > 0;) sink(i);
  }

  bool next(Record& record) override {
    if (heap_.empty()) return false;
    record = heads_[heap_.front()];
    advance();
    while (!heap_.empty() && !Record::before(record, heads_[heap_.front()]) &&
           Record::combine(record, heads_[heap_.front()])) {
      advance();
    }
    return true;
  }

 private:
  void advance() {
    const std::size_t source = heap_.front();
    if (!sources_[source]->next(heads_[source])) {
      heap_.front() = heap_.back();
      heap_.pop_back();
    }
    sink(0);
  }

  // Lets the head at this place of the heap (smallest first) down to where it belongs.
  void sink(std::size_t at) {
    if (at >= heap_.size()) return;
    const std::size_t moving = heap_[at];
    for (;;) {
      std::size_t child = 2 * at + 1;
      if (child >= heap_.size()) break;
      if (child + 1 < heap_.size() &&
          Record::before(heads_[heap_[child + 1]], heads_[heap_[child]]))
        ++child;
      if (!Record::before(heads_[heap_[child]], heads_[moving])) break;
      heap_[at] = heap_[child];
      at = child;
    }
    heap_[at] = moving;
  }

  std::vector<std::unique_ptr<RecordCursor<Record>>> sources_;
  std::vector<Record> heads_;      // the next record of each source
  std::vector<std::size_t> heap_;  // sources that are not at their end
};

// Runs in scratch. Safe to add to from several threads.
template <typename Record>
class SortedRuns {
 public:
  // Runs that may be open at once; when one more would stand on a level, all of the level are
  // merged into one on the next, so that the memory and the descriptors to read all of them stay
  // bounded.
  static constexpr std::size_t fan_in = 32;
  static constexpr std::size_t block_records = (std::size_t{1} << 14) / sizeof(Record);

  explicit SortedRuns(Job& job) : job_(job) {}

  // Writes all of `records`, which gives them in order, as one run.
  void add(RecordCursor<Record>& records) {
    std::unique_ptr<PackedFile> run = write(records);
    const std::scoped_lock lock(mutex_);
    insert(0, std::move(run));
  }

  [[nodiscard]] bool empty() const { return levels_.empty(); }

  void add_cursors(std::vector<std::unique_ptr<RecordCursor<Record>>>& sources) const {
    for (const auto& level : levels_) {
      for (const auto& run : level) sources.push_back(std::make_unique<RunCursor<Record>>(*run));
    }
  }

  // Memory to read every run at once, at the most: what the plan sets aside.
  static constexpr std::uint64_t merge_memory() {
    constexpr std::uint64_t levels =
        3;  // a run of level 3 is 32^3 times the table: nobody gets there
    return levels * fan_in * (2 * block_records * sizeof(Record) + 1024);
  }

 private:
  std::unique_ptr<PackedFile> write(RecordCursor<Record>& records) {
    auto run = std::make_unique<PackedFile>(job_);
    std::vector<Record> block;
    block.reserve(block_records);
    std::uint64_t blocks = 0;
    for (Record record; records.next(record);) {
      block.push_back(record);
      if (block.size() < block_records) continue;
      run->append(std::as_bytes(std::span(block)));
      block.clear();
      if (++blocks % 64 == 0) job_.progress.check_cancelled();
    }
    if (!block.empty()) run->append(std::as_bytes(std::span(block)));
    run->finish();
    return run;
  }

  void insert(std::size_t level, std::unique_ptr<PackedFile> run) {
    if (levels_.size() <= level) levels_.resize(level + 1);
    levels_[level].push_back(std::move(run));
    if (levels_[level].size() < fan_in) return;
    std::vector<std::unique_ptr<RecordCursor<Record>>> sources;
    for (const auto& full : levels_[level])
      sources.push_back(std::make_unique<RunCursor<Record>>(*full));
    MergedCursor<Record> merged(std::move(sources));
    std::unique_ptr<PackedFile> whole = write(merged);
    levels_[level].clear();
    insert(level + 1, std::move(whole));
  }

  Job& job_;
  std::mutex mutex_;
  std::vector<std::vector<std::unique_ptr<PackedFile>>> levels_;
};

}  // namespace winnow
