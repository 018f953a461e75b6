// The memory budget: every component reserves before it allocates.
#pragma once

#include <atomic>
#include <cstdint>
#include <functional>
#include <utility>

namespace winnow {

inline constexpr std::uint64_t mebibyte = std::uint64_t{1} << 20;

class Budget;

// A part of the budget; given back when it goes.
class Reservation {
 public:
  Reservation() = default;
  Reservation(Budget* budget, std::uint64_t bytes) : budget_(budget), bytes_(bytes) {}
  Reservation(Reservation&& other) noexcept
      : budget_(std::exchange(other.budget_, nullptr)), bytes_(std::exchange(other.bytes_, 0)) {}
  Reservation& operator=(Reservation&& other) noexcept {
    std::swap(budget_, other.budget_);
    std::swap(bytes_, other.bytes_);
    return *this;
  }
  Reservation(const Reservation&) = delete;
  Reservation& operator=(const Reservation&) = delete;
  ~Reservation() { release(); }

  void release() noexcept;
  [[nodiscard]] std::uint64_t bytes() const { return bytes_; }

  // False where the reservation was refused.
  explicit operator bool() const { return budget_ != nullptr; }

 private:
  Budget* budget_ = nullptr;
  std::uint64_t bytes_ = 0;
};

class Budget {
 public:
  explicit Budget(std::uint64_t total) : total_(total) {}
  Budget(const Budget&) = delete;
  Budget& operator=(const Budget&) = delete;

  // An empty reservation where the budget does not hold it: then the caller spills.
  [[nodiscard]] Reservation try_reserve(std::uint64_t bytes);

  // For what the plan has already made room for; throws Error(resources) naming `what` where it
  // does not fit.
  [[nodiscard]] Reservation reserve(std::uint64_t bytes, const char* what);

  // What the run will ask for besides, at the least: messages then name a budget that is really
  // enough.
  void expect(std::uint64_t bytes) { expected_ = bytes; }
  // held(total): what the run holds at the most, beside what it is going to ask for, under a budget
  // of `total`. Parts of a run grow with its budget. Used in place of the above until it is empty.
  void expect_held(std::function<std::uint64_t(std::uint64_t total)> held) {
    held_ = std::move(held);
  }

  [[nodiscard]] std::uint64_t total() const { return total_; }
  [[nodiscard]] std::uint64_t used() const { return used_.load(std::memory_order_relaxed); }
  [[nodiscard]] std::uint64_t left() const { return total_ - used(); }

 private:
  friend class Reservation;

  // The smallest budget, in whole mebibytes, that holds so much more.
  [[nodiscard]] std::uint64_t enough_for(std::uint64_t bytes) const;

  std::uint64_t total_;
  std::uint64_t expected_ = 0;
  std::function<std::uint64_t(std::uint64_t)> held_;
  std::atomic<std::uint64_t> used_{0};
};

}  // namespace winnow
