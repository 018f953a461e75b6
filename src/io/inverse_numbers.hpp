// A list of numbers turned round: of each number its place in the list.
#pragma once

#include "io/sorted_records.hpp"
#include "io/spool_records.hpp"

#include <cstdint>
#include <optional>
#include <stdexcept>
#include <vector>

namespace winnow {

// Filled by one thread with all numbers below `count`, each once.
class InverseNumbers {
 public:
  // Takes at most `memory`.
  InverseNumbers(Job& job, std::uint64_t count, std::uint64_t memory) : job_(job), count_(count) {
    const std::uint64_t bytes = count * sizeof(std::uint32_t);
    if (bytes > memory) {
      sorted_.emplace(job, memory);
      return;
    }
    reserved_ = job.budget.reserve(bytes, "renumbering");
    places_.assign(count, absent);
  }

  // To the end of the list.
  void add(std::uint32_t number) {
    if (sorted_) {
      sorted_->add({number, next_++});
      return;
    }
    if (number >= count_ || places_[number] != absent) refuse();
    places_[number] = next_++;
  }

  // Appends the places of all numbers, in their order. Once, when the list is whole.
  void append_to(Spool& places) {
    if (next_ != count_) refuse();
    Appender<std::uint32_t> append(job_, places);
    if (sorted_) {
      MergedCursor<Placed> merged = sorted_->merged();
      std::uint32_t number = 0;
      for (Placed placed{}; merged.next(placed); append.add(placed.place)) {
        if (placed.number != number++) refuse();
      }
    } else {
      for (const std::uint32_t place : places_) append.add(place);
    }
    append.flush();
  }

 private:
  static constexpr std::uint32_t absent = UINT32_MAX;

  struct Placed {
    std::uint32_t number, place;

    static bool before(const Placed& a, const Placed& b) { return a.number < b.number; }
    static bool combine(Placed&, const Placed&) { return false; }
  };

  [[noreturn]] static void refuse() {
    throw std::logic_error("a list to be turned round has a number not once");
  }

  Job& job_;
  std::uint64_t count_;
  std::uint32_t next_ = 0;
  Reservation reserved_;
  std::vector<std::uint32_t> places_;            // where all fit into memory
  std::optional<SortedRecords<Placed>> sorted_;  // where they do not
};

}  // namespace winnow
