#include "measure/part_count.hpp"

#include "base/memory_shares.hpp"
#include "base/wide.hpp"

#include <algorithm>
#include <mutex>

namespace winnow {

namespace {

constexpr std::uint64_t slot_bytes = sizeof(std::uint64_t) + sizeof(std::uint32_t);
constexpr std::uint64_t fewest_slots = std::uint64_t{1} << 15;
constexpr std::uint64_t slots_a_thread =
    1024;  // for what threads add before they know that the table is full
constexpr std::uint64_t most_slots = UINT32_MAX - 1;

}  // namespace

PartCount::PartCount(Job& job, std::uint64_t memory, std::optional<std::uint64_t> positions)
    : job_(job),
      link_memory_(share::count::links(memory)),
      recent_(job.threads, [] { return std::make_unique<Recent>(); }) {
  const std::uint64_t room = std::min((memory - link_memory_) / slot_bytes, most_slots);
  const std::uint64_t wanted = positions ? std::min(*positions, most_slots) * 3 / 2 : most_slots;
  const std::uint64_t slots =
      std::max(std::min(room, wanted), fewest_slots) + job.threads * slots_a_thread;
  pages_ = Pages::allocate(job.budget, slots * slot_bytes, "connected parts");
  auto* const keys = reinterpret_cast<std::atomic<std::uint64_t>*>(pages_.data());
  keys_ = {keys, slots};
  parents_ = {reinterpret_cast<std::atomic<Slot>*>(keys + slots), slots};
  full_ = slots / 4 * 3 - job.threads * 3 * most_at_once;
}

PartCount::Slot PartCount::slot_of(std::uint64_t key, Recent& recent, std::uint64_t& fresh) {
  if (key == 0) key = 1;
  const std::size_t place = key >> (64 - Recent::bits);
  if (recent.key[place] == key) return recent.slot[place];
  std::uint64_t slot = scaled_hash(key * 0x9E3779B97F4A7C15U, keys_.size());
  for (;; slot = slot + 1 == keys_.size() ? 0 : slot + 1) {
    std::uint64_t there = keys_[slot].load(std::memory_order_relaxed);
    if (there == 0 && keys_[slot].compare_exchange_strong(there, key, std::memory_order_relaxed)) {
      ++fresh;
      break;
    }
    if (there == key) break;
  }
  recent.key[place] = key;
  return recent.slot[place] = static_cast<Slot>(slot);
}

PartCount::Slot PartCount::root(Slot slot) {
  for (;;) {
    Slot parent = parents_[slot].load(std::memory_order_relaxed);
    if (parent == 0) return slot;
    const Slot above = parents_[parent - 1].load(std::memory_order_relaxed);
    if (above == 0) return parent - 1;
    parents_[slot].compare_exchange_weak(parent, above, std::memory_order_relaxed);
    slot = above - 1;
  }
}

void PartCount::join(Slot one, Slot other) {
  for (;;) {
    one = root(one);
    other = root(other);
    if (one == other) return;
    // Parents have lower numbers, so that no circle comes about.
    if (one < other) std::swap(one, other);
    Slot none = 0;
    if (parents_[one].compare_exchange_strong(none, other + 1, std::memory_order_relaxed)) return;
  }
}

void PartCount::add(std::span<const std::array<std::uint64_t, 3>> faces) {
  if (used_.load() >= full_) {
    const std::unique_lock alone(emptying_);
    if (used_.load() >= full_) empty_table();
  }
  const std::shared_lock shared(emptying_);
  Recent& recent = recent_.local();
  if (recent.emptied != emptied_) {
    recent.key.fill(0);
    recent.emptied = emptied_;
  }
  std::uint64_t fresh = 0;
  for (const auto& [a, b, c] : faces) {
    if (a == b && b == c) continue;
    const Slot first = slot_of(a, recent, fresh);
    join(first, slot_of(b, recent, fresh));
    join(first, slot_of(c, recent, fresh));
  }
  used_ += fresh;
}

void PartCount::empty_table() {
  if (links_ == nullptr) links_ = std::make_unique<Components>(job_, link_memory_);
  for (std::size_t slot = 0; slot < keys_.size(); ++slot) {
    if (slot % 4096 == 0) job_.progress.check_cancelled();
    const std::uint64_t key = keys_[slot].load();
    if (key == 0) continue;
    const Slot top = root(static_cast<Slot>(slot));
    if (top != slot) links_->link(keys_[top].load(), key);
  }
  pages_.clear();
  used_ = 0;
  ++emptied_;
}

std::uint64_t PartCount::finish() {
  std::uint64_t parts = 0;
  if (links_ == nullptr) {
    for (std::size_t slot = 0; slot < keys_.size(); ++slot) {
      if (slot % 4096 == 0) job_.progress.check_cancelled();
      parts += keys_[slot].load() != 0 && parents_[slot].load() == 0 ? 1 : 0;
    }
    return parts;
  }
  empty_table();
  pages_ = {};
  std::uint64_t last = 0;
  links_->finish([&](std::uint64_t first, std::uint64_t /*other*/) {
    parts += parts == 0 || first != last ? 1 : 0;
    last = first;
  });
  return parts;
}

}  // namespace winnow
