#include "cluster/cell_table.hpp"

#include "base/hash.hpp"
#include "base/parallel.hpp"
#include "base/wide.hpp"

#include <algorithm>
#include <array>
#include <bit>

#include <tbb/task_arena.h>

namespace winnow {

namespace {

constexpr std::size_t first_capacity = 512;

// Linear probing stays short up to here, and from here to full() there is room for what is under
// way when spilling is asked for.
constexpr std::size_t high_water(std::size_t capacity) {
  return capacity - capacity / 4;
}
constexpr std::size_t full(std::size_t capacity) {
  return capacity - capacity / 10;
}

}  // namespace

template <typename Sum>
CellTable<Sum>::CellTable(Job& job, std::uint64_t memory, std::size_t parts)
    : job_(job), budget_(memory), parts_(std::bit_ceil(parts)), runs_(job) {}

template <typename Sum>
Sum& CellTable<Sum>::slot(Part& part, CellKey key) const {
  const std::span<Sum> entries = part.memory.template as<Sum>();
  // The high bits of the hash choose the slot, the low bits the part.
  std::size_t at = scaled_hash(mixed_hash(key), part.capacity);
  while (!entries[at].empty() && entries[at].key != key) at = at + 1 == part.capacity ? 0 : at + 1;
  return entries[at];
}

// Fourfold while there is plenty, as every growth clears and fills pages anew; then by half: with
// doubling, a budget would on average hold the table three quarters empty. The last step goes as
// far as leaves room for the old and the new memory of a part or two at once.
template <typename Sum>
bool CellTable<Sum>::grow(Part& part) {
  const std::size_t share = budget_.total() / parts_.size() / sizeof(Sum);
  const bool plenty = part.capacity * 16 < share;
  const std::size_t wanted = part.capacity == 0 ? first_capacity
                             : plenty           ? part.capacity * 4
                                                : part.capacity + part.capacity / 2;
  const std::size_t most = share - share / 8;
  const std::size_t capacity = std::min(wanted, most);
  if (capacity < part.capacity + part.capacity / 8) return false;
  Pages memory = Pages::try_allocate(budget_, capacity * sizeof(Sum));
  if (!memory) return false;
  memory.touch();
  const Pages old = std::exchange(part.memory, std::move(memory));
  const std::size_t old_capacity = std::exchange(part.capacity, capacity);
  for (const Sum& entry : old.template as<Sum>().first(old_capacity)) {
    if (!entry.empty()) slot(part, entry.key) = entry;
  }
  return true;
}

template <typename Sum>
void CellTable<Sum>::add_to(Part& part, const Sum& entry) {
  if (part.count >= high_water(part.capacity) && !grow(part)) {
    nearly_full_.store(true, std::memory_order_relaxed);
  }
  Sum& found = slot(part, entry.key);
  if (found.empty()) {
    found = entry;
    ++part.count;
  } else if (!Sum::combine(found, entry)) {
    part.overflow.push_back(found);
    found = entry;
  }
}

template <typename Sum>
void CellTable<Sum>::add(std::span<Sum> entries) {
  const std::size_t mask = parts_.size() - 1;
  std::array<std::uint32_t, 257> start{};
  std::vector<std::uint32_t> order(entries.size());
  for (const Sum& entry : entries) ++start[(mixed_hash(entry.key) & mask) + 1];
  for (std::size_t i = 0; i <= mask; ++i) start[i + 1] += start[i];
  std::array<std::uint32_t, 257> next = start;
  for (std::uint32_t i = 0; i < entries.size(); ++i)
    order[next[mixed_hash(entries[i].key) & mask]++] = i;

  for (std::size_t p = 0; p <= mask; ++p) {
    if (start[p] == start[p + 1]) continue;
    Part& part = parts_[p];
    std::unique_lock lock(part.mutex);
    constexpr std::uint32_t ahead = 4;
    for (std::uint32_t i = start[p]; i < start[p + 1]; ++i) {
      if (part.capacity != 0 && i + ahead < start[p + 1]) {
        const CellKey key = entries[order[i + ahead]].key;
        const std::size_t at = scaled_hash(mixed_hash(key), part.capacity);
        __builtin_prefetch(part.memory.template as<Sum>().data() + at, 1);
      }
      // Nobody came to spill in time. Rare, slow, and right.
      if (part.count >= full(part.capacity) && part.capacity != 0 && nearly_full()) {
        lock.unlock();
        spill_locked();
        lock.lock();
      }
      add_to(part, entries[order[i]]);
    }
  }
}

template <typename Sum>
void CellTable<Sum>::spill_locked() {
  std::vector<std::unique_lock<std::mutex>> locks;
  for (Part& part : parts_) locks.emplace_back(part.mutex);
  if (!nearly_full()) return;  // another thread was first
  // Isolated: a thread that waits in here must not pick up another batch and wait for these locks.
  tbb::this_task_arena::isolate([this] { spill(); });
}

template <typename Sum>
std::vector<std::unique_ptr<RecordCursor<Sum>>> CellTable<Sum>::sort_parts() {
  parallel_for(parts_.size(), [this](std::size_t p) {
    Part& part = parts_[p];
    const std::span<Sum> entries = part.memory.template as<Sum>().first(part.capacity);
    std::size_t kept = 0;
    for (const Sum& entry : entries) {
      if (!entry.empty()) entries[kept++] = entry;
    }
    const std::span<Sum> sums = entries.first(kept);
    const auto before = job_.progress.cancellable(Before<Sum>());
    std::sort(sums.begin(), sums.end(), before);
    std::sort(part.overflow.begin(), part.overflow.end(), before);
  });
  std::vector<std::unique_ptr<RecordCursor<Sum>>> sources;
  for (Part& part : parts_) {
    const std::span<const Sum> entries = part.memory.template as<Sum>().first(part.count);
    if (!entries.empty()) sources.push_back(std::make_unique<MemoryCursor<Sum>>(entries));
    if (!part.overflow.empty())
      sources.push_back(std::make_unique<MemoryCursor<Sum>>(part.overflow));
  }
  return sources;
}

template <typename Sum>
void CellTable<Sum>::spill() {
  MergedCursor<Sum> merged(sort_parts());
  runs_.add(merged);
  for (Part& part : parts_) {
    part.memory.clear();
    part.memory.touch();
    part.count = 0;
    part.overflow.clear();
  }
  nearly_full_ = false;
}

template <typename Sum>
std::unique_ptr<RecordCursor<Sum>> CellTable<Sum>::finish() {
  std::vector<std::unique_ptr<RecordCursor<Sum>>> sources = sort_parts();
  runs_.add_cursors(sources);
  return std::make_unique<MergedCursor<Sum>>(std::move(sources));
}

template <typename Sum>
void CellTable<Sum>::release() {
  std::vector<Part>(parts_.size()).swap(parts_);
}

template class CellTable<CellSum>;
template class CellTable<QuadricCellSum>;
template class CellTable<AttributeSum<4>>;
template class CellTable<AttributeSum<8>>;
template class CellTable<AttributeSum<16>>;

}  // namespace winnow
