// Asking now and then, in loops of short steps, whether to go on.
#pragma once

#include <cstdint>
#include <functional>
#include <utility>

namespace winnow {

// For one thread.
class Pace {
 public:
  static constexpr std::uint32_t steps = 1 << 16;

  // `ask` throws where the loop is to end; nothing: it always goes on.
  explicit Pace(std::function<void()> ask = {}) : ask_(std::move(ask)) {}

  // A step; asks in each of so many.
  void operator()() {
    if (--left_ == 0) ask();
  }

  void ask() {
    left_ = steps;
    if (ask_) ask_();
  }

 private:
  std::function<void()> ask_;
  std::uint32_t left_ = steps;
};

}  // namespace winnow
