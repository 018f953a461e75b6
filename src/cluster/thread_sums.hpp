// What one thread adds to a table of sums: through a cache of its own, and many at a time.
#pragma once

#include "base/morton.hpp"
#include "cluster/cell_table.hpp"
#include "cluster/front_cache.hpp"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace winnow {

template <typename Sum>
class ThreadSums {
 public:
  // How keys are given: packed cells become Morton keys in the table, others stay.
  enum class Keys { packed_cells, as_they_are };

  ThreadSums(CellTable<Sum>& table, Keys keys) : table_(table), keys_(keys) {
    pending_.reserve(most_pending);
  }

  // The sum of `key`, to be added to, with room for `weight` more.
  Sum& entry(std::uint64_t key, std::uint64_t weight) {
    return cache_.entry(key, weight, [this](const Sum& line) { evict(line); });
  }

  // Adds a sum with the key that it has in the table.
  void add(const Sum& sum) {
    pending_.push_back(sum);
    if (pending_.size() == most_pending) flush();
  }

  // All that is still here goes to the table.
  void finish() {
    cache_.empty_into([this](const Sum& line) { evict(line); });
    flush();
  }

  static constexpr std::uint64_t memory() {
    return FrontCache<Sum>::bytes + 2 * most_pending * sizeof(Sum);
  }

 private:
  static constexpr std::size_t most_pending = 1024;

  void evict(const Sum& line) {
    Sum sum = line;
    if (keys_ == Keys::packed_cells) sum.key = morton_key(PackedCell{line.key});
    add(sum);
  }

  void flush() {
    table_.add(pending_);
    pending_.clear();
  }

  CellTable<Sum>& table_;
  Keys keys_;
  FrontCache<Sum> cache_;
  std::vector<Sum> pending_;  // on their way to the table
};

}  // namespace winnow
