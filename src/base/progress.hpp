// Counting what is done, telling of it now and then, and noticing that the caller wants to stop.
#pragma once

#include <winnow/context.hpp>

#include <atomic>
#include <chrono>
#include <cstdint>
#include <mutex>

namespace winnow {

// Safe to use from all threads at once.
class ProgressMeter {
 public:
  explicit ProgressMeter(Context& context) : context_(context) {}

  void begin(const char* stage, std::uint64_t total, const char* unit);

  // A stage inside of another, which goes on where it was when this goes.
  class Inner {
   public:
    Inner(ProgressMeter& meter, const char* stage, std::uint64_t total, const char* unit);
    ~Inner();
    Inner(const Inner&) = delete;
    Inner& operator=(const Inner&) = delete;

   private:
    ProgressMeter& meter_;
    const char* stage_;
    const char* unit_;
    std::uint64_t total_, done_;
  };

  // Counts `amount` more and throws Error(cancelled) if the caller asked to stop.
  void advance(std::uint64_t amount);

  [[nodiscard]] bool cancelled() const { return context_.cancelled(); }
  void check_cancelled() const {
    if (cancelled()) stop();
  }

  // `before` for sorting: what many gibibytes take to sort is longer than a caller waits who wants
  // to stop.
  template <typename Before>
  [[nodiscard]] auto cancellable(Before before) const {
    return [this, before](const auto& a, const auto& b) {
      check_cancelled();
      return before(a, b);
    };
  }

 private:
  [[noreturn]] static void stop();

  using Clock = std::chrono::steady_clock;

  Context& context_;
  std::mutex telling_;
  const char* stage_ = "";
  const char* unit_ = "";
  std::uint64_t total_ = 0;
  std::atomic<std::uint64_t> done_{0};
  std::atomic<Clock::rep> next_{0};
};

// Seconds since it was made.
class Stopwatch {
 public:
  [[nodiscard]] double seconds() const {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
  }

 private:
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

}  // namespace winnow
