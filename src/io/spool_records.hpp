// Records of one type in a spool, or in whatever else takes them in chunks.
#pragma once

#include "io/spool.hpp"

#include <algorithm>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace winnow {

// Enough that a read or write is worth its call, and little beside any share of the budget.
inline constexpr std::size_t chunk_records = 4096;

template <typename Record>
std::uint64_t record_count(const Spool& spool) {
  return spool.size() / sizeof(Record);
}

template <typename Record>
Record read_record(const Spool& spool, std::uint64_t number) {
  Record record{};
  spool.read(number * sizeof record, std::as_writable_bytes(std::span(&record, 1)));
  return record;
}

// All records of a spool in memory.
template <typename Record>
std::span<const Record> records_in_memory(const Spool& spool) {
  return {reinterpret_cast<const Record*>(spool.data()), record_count<Record>(spool)};
}

// `room`: for how many more.
template <typename Record>
std::vector<Record> read_records(const Spool& spool, std::uint64_t first, std::uint64_t count,
                                 std::uint64_t room = 0) {
  std::vector<Record> records;
  records.reserve(count + room);
  if (spool.in_memory()) {
    const std::span<const Record> wanted = records_in_memory<Record>(spool).subspan(first, count);
    records.assign(wanted.begin(), wanted.end());
    return records;
  }
  records.resize(count);
  spool.read(first * sizeof(Record), std::as_writable_bytes(std::span(records)));
  return records;
}

template <typename Record>
void append_records(Spool& spool, std::span<const Record> records) {
  spool.append(std::as_bytes(records));
}

// All records, one after the other. Notices cancelling.
template <typename Record>
class SpoolCursor {
 public:
  SpoolCursor(const Job& job, const Spool& spool) : job_(job), spool_(spool) {}
  SpoolCursor(SpoolCursor&&) noexcept = default;  // not copied: records_ may be the chunk

  // False at the end.
  bool next(Record& record) {
    if (at_ == records_.size() && !refill()) return false;
    record = records_[at_++];
    return true;
  }

  // each(record) for all that are left.
  template <typename Each>
  void for_each(const Each& each) {
    while (at_ < records_.size() || refill()) {
      for (const Record& record : records_.subspan(at_)) each(record);
      at_ = records_.size();
    }
  }

 private:
  bool refill() {
    job_.progress.check_cancelled();
    const std::uint64_t left = record_count<Record>(spool_) - read_;
    const std::uint64_t count = std::min<std::uint64_t>(left, chunk_records);
    if (spool_.in_memory()) {
      records_ = records_in_memory<Record>(spool_).subspan(read_, count);
    } else {
      chunk_ = read_records<Record>(spool_, read_, count);
      records_ = chunk_;
    }
    read_ += count;
    at_ = 0;
    return !records_.empty();
  }

  const Job& job_;
  const Spool& spool_;
  std::span<const Record> records_;
  std::vector<Record> chunk_;  // of a spool in scratch
  std::size_t at_ = 0;
  std::uint64_t read_ = 0;
};

// Gathers records to chunks. `Into` is a Spool, or has append(span of records). Notices cancelling.
template <typename Record, typename Into = Spool>
class Appender {
 public:
  Appender(const Job& job, Into& into) : job_(job), into_(into) { chunk_.reserve(chunk_records); }

  void add(const Record& record) {
    chunk_.push_back(record);
    if (chunk_.size() == chunk_records) flush();
  }

  // To be called behind the last.
  void flush() {
    job_.progress.check_cancelled();
    if constexpr (std::same_as<Into, Spool>) {
      append_records<Record>(into_, chunk_);
    } else {
      into_.append(chunk_);
    }
    chunk_.clear();
  }

 private:
  const Job& job_;
  Into& into_;
  std::vector<Record> chunk_;
};

}  // namespace winnow
