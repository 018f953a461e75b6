// Records that come in any order and are sorted part by part, each a range of them: in memory while
// they fit, in scratch beyond it.
#pragma once

#include "base/checksum.hpp"
#include "base/growing_pages.hpp"
#include "base/memory_shares.hpp"
#include "base/parallel.hpp"
#include "base/per_slot.hpp"
#include "base/rank_order.hpp"
#include "io/scratch.hpp"
#include "io/sorted_records.hpp"

#include <algorithm>
#include <bit>
#include <cstdint>
#include <cstring>
#include <memory>
#include <mutex>
#include <optional>
#include <span>
#include <type_traits>
#include <vector>

namespace winnow {

// How memory and records are shared out. A part that has much more than its share of the records is
// sorted in runs, which is slower.
struct PartsPlan {
  std::size_t parts;
  std::size_t chunk_bytes;
  std::uint64_t chunks;           // bytes of all
  std::uint64_t sorting;          // bytes of one part being sorted, or of a few
  std::uint64_t largest_records;  // of a part that is sorted at once

  // For about so many records in `memory`. `bytes_at_work`: of a record of a part that is sorted.
  static PartsPlan divide(std::uint64_t memory, unsigned threads, std::uint64_t records,
                          std::size_t record_bytes, std::size_t bytes_at_work);

  [[nodiscard]] static std::size_t at_work(unsigned threads) { return threads + std::size_t{1}; }
};

// Added by all threads of the job's arena, each to lists of its own; when all are added, given in
// order. Records have before() and combine(), as in SortedList, and rank(), a whole number that
// never falls in that order.
template <typename Record>
class PartedRecords {
  static_assert(std::is_trivially_copyable_v<Record>);

 public:
  static PartsPlan plan(std::uint64_t memory, unsigned threads, std::uint64_t records,
                        std::size_t result_bytes) {
    return PartsPlan::divide(memory, threads, records, sizeof(Record),
                             2 * sizeof(Record) + RankOrder::bytes_a_place + result_bytes);
  }

  PartedRecords(Job& job, const PartsPlan& plan)
      : job_(job),
        plan_(plan),
        reserved_(job.budget.reserve(plan.chunks + plan.sorting, "sorting")),
        budget_(plan.chunks),
        pages_(budget_, plan.chunks),
        spare_(pages_.limit() / plan.chunk_bytes),
        slots_(job.threads, [this] { return std::make_unique<Lists>(*this); }) {
    spare_ -= std::min<std::uint64_t>(spare_, job.threads * plan.parts);
  }

  // One thread's records of each part.
  class Lists {
   public:
    explicit Lists(PartedRecords& owner) : owner_(owner), lists_(owner.plan_.parts) {}

    void add(std::size_t part, const Record& record) {
      List& list = lists_[part];
      if (list.next == list.end) owner_.extend(list);
      *list.next++ = record;
    }

   private:
    friend class PartedRecords;
    // Chunks begin with a link to the one before.
    struct Link {
      std::uint64_t place = none;
      std::uint64_t sum = 0;  // of a chunk in scratch
      bool scratch = false;
    };
    struct List {
      Record* next = nullptr;
      Record* end = nullptr;
      std::byte* chunk = nullptr;
      std::uint64_t full = 0;  // chunks before
    };
    PartedRecords& owner_;
    std::vector<List> lists_;
  };

  Lists& local() { return slots_.local(); }

  // Calls work(records, result) for stretches of sorted records, several at once, and
  // finish(result) in their order, one at a time. Records that are equal may lie in two stretches.
  template <typename Result, typename Work, typename Finish>
  void for_each_stretch(const Work& work, const Finish& finish) {
    struct Item {
      std::size_t part = 0;
      bool sorted = false;
      std::vector<Record> records, in_order;
      RankOrder order;
      Result result;
    };
    std::size_t part = 0;
    std::optional<SortedRecords<Record>> large;
    std::optional<MergedCursor<Record>> merged;
    pipeline<Item>(
        PartsPlan::at_work(job_.threads),
        [&](Item& item) {
          job_.progress.check_cancelled();
          while (part < plan_.parts || merged) {
            if (merged) {
              item.in_order.clear();
              for (Record record;
                   item.in_order.size() < plan_.largest_records && merged->next(record);)
                item.in_order.push_back(record);
              item.sorted = true;
              if (!item.in_order.empty()) return true;
              merged.reset();
              large.reset();
              continue;
            }
            item.part = part++;
            item.sorted = false;
            const std::uint64_t records = count(item.part);
            if (records == 0) continue;
            if (records <= plan_.largest_records) return true;
            // In memory where there is room.
            large.emplace(job_,
                          std::max({plan_.sorting / 4, SortedRecords<Record>::least_memory,
                                    std::min(2 * records * sizeof(Record),
                                             share::left::crowded_part(job_.budget.left()))}));
            for_each_chunk(item.part, [&](std::span<const Record> chunk) {
              for (const Record& record : chunk) large->add(record);
            });
            merged.emplace(large->merged());
          }
          return false;
        },
        [&](Item& item) {
          if (!item.sorted) sort(item.part, item.records, item.order, item.in_order);
          work(std::span<const Record>(item.in_order), item.result);
        },
        [&](Item& item) { finish(item.result); });
  }

 private:
  using Link = typename Lists::Link;
  using List = typename Lists::List;
  static constexpr std::uint64_t none = UINT64_MAX;

  [[nodiscard]] std::size_t chunk_records() const {
    return (plan_.chunk_bytes - sizeof(Link)) / sizeof(Record);
  }
  static Record* records_of(std::byte* chunk) {
    return reinterpret_cast<Record*>(chunk + sizeof(Link));
  }

  // Gives the list an empty chunk.
  void extend(List& list) {
    Link link;
    if (list.chunk == nullptr) {
      list.chunk = new_chunk();
    } else {
      ++list.full;
      link.place = static_cast<std::uint64_t>(list.chunk - pages_.data());
      if (std::byte* chunk = spare_chunk(); chunk != nullptr) {
        list.chunk = chunk;
      } else {
        const std::span<const std::byte> bytes(list.chunk, plan_.chunk_bytes);
        link = {0, Checksum::of(bytes), true};
        const std::scoped_lock lock(mutex_);
        if (file_ == nullptr)
          file_ = std::make_unique<ScratchFile>(job_.scratch, ScratchFile::Checked::no);
        link.place = file_->size();
        file_->append(bytes);
      }
    }
    std::memcpy(list.chunk, &link, sizeof link);
    list.next = records_of(list.chunk);
    list.end = list.next + chunk_records();
  }

  std::byte* spare_chunk() {
    {
      const std::scoped_lock lock(mutex_);
      if (spare_ == 0) return nullptr;
      --spare_;
    }
    return new_chunk();
  }

  std::byte* new_chunk() {
    const std::scoped_lock lock(mutex_);
    const std::size_t begin = used_;
    used_ += plan_.chunk_bytes;
    if (!pages_.grow_to(used_)) throw std::bad_alloc();
    return pages_.data() + begin;
  }

  [[nodiscard]] std::uint64_t count(std::size_t part) const {
    std::uint64_t sum = 0;
    for (const Lists* lists : slots_.all()) {
      const List& list = lists->lists_[part];
      if (list.chunk != nullptr)
        sum += list.full * chunk_records() +
               static_cast<std::uint64_t>(list.next - records_of(list.chunk));
    }
    return sum;
  }

  template <typename Each>
  void for_each_chunk(std::size_t part, const Each& each) const {
    std::vector<std::byte> read;
    for (const Lists* lists : slots_.all()) {
      const List& list = lists->lists_[part];
      if (list.chunk == nullptr) continue;
      std::byte* chunk = list.chunk;
      auto records = static_cast<std::size_t>(list.next - records_of(chunk));
      for (;;) {
        each(std::span<const Record>(records_of(chunk), records));
        Link link;
        std::memcpy(&link, chunk, sizeof link);
        if (link.place == none) break;
        if (link.scratch) {
          read.resize(plan_.chunk_bytes);
          file_->read(link.place, read);
          if (Checksum::of(read) != link.sum) file_->damaged();
          chunk = read.data();
        } else {
          chunk = pages_.data() + link.place;
        }
        records = chunk_records();
      }
    }
  }

  void sort(std::size_t part, std::vector<Record>& records, RankOrder& order,
            std::vector<Record>& sorted) const {
    records.clear();
    records.reserve(count(part));
    for_each_chunk(part, [&](std::span<const Record> chunk) {
      records.insert(records.end(), chunk.begin(), chunk.end());
    });
    const auto places = order.sort(
        records.size(), [&](std::uint32_t i) { return records[i].rank(); },
        [&](std::uint32_t i, std::uint32_t k) { return Record::before(records[i], records[k]); });
    sorted.resize(records.size());
    for (std::size_t i = 0; i < places.size(); ++i) sorted[i] = records[places[i].number];
  }

  Job& job_;
  PartsPlan plan_;
  Reservation reserved_;
  Budget budget_;
  GrowingPages pages_;
  std::mutex mutex_;
  std::size_t used_ = 0;
  std::uint64_t spare_;  // chunks beside the first of each list
  std::unique_ptr<ScratchFile> file_;
  PerSlot<Lists> slots_;
};

}  // namespace winnow
