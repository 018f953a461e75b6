// The upper half of numbers that come, change and go, one for each vertex, in logarithmic time.
#pragma once

#include "decimate/price_queue.hpp"

#include <cstddef>
#include <cstdint>

namespace winnow {

// Two heaps that meet at the median. Where many numbers equal it, some of them are in the lower half.
class RunningMedian {
 public:
  explicit RunningMedian(VertexNumber vertices) : upper_(vertices), lower_(vertices) {}

  static constexpr std::uint64_t memory(std::uint64_t vertices) { return 2 * PriceQueue::memory(vertices); }

  [[nodiscard]] bool empty() const { return upper_.empty(); }
  // Of an even count the larger of the two in the middle.
  [[nodiscard]] double median() const { return upper_.top().price; }
  // Half of the numbers, and the middle one of an odd count.
  [[nodiscard]] bool in_upper_half(VertexNumber v) const { return upper_.holds(v); }

  // crossed(vertex) for every vertex that changes its half so that they are as large.
  template <typename Crossed>
  void set(VertexNumber v, double number, const Crossed& crossed) {
    take_out(v);
    if (empty() || number >= median()) {
      upper_.set(v, number);
      ++in_upper_;
    } else {
      lower_.set(v, -number);
      ++in_lower_;
    }
    balance(crossed);
  }

  template <typename Crossed>
  void erase(VertexNumber v, const Crossed& crossed) {
    take_out(v);
    balance(crossed);
  }

 private:
  void take_out(VertexNumber v) {
    if (upper_.holds(v)) --in_upper_;
    if (lower_.holds(v)) --in_lower_;
    upper_.remove(v);
    lower_.remove(v);
  }

  template <typename Crossed>
  void balance(const Crossed& crossed) {
    while (in_upper_ < in_lower_) {
      const PriceQueue::Offer largest = lower_.top();
      lower_.remove(largest.vertex);
      upper_.set(largest.vertex, -largest.price);
      --in_lower_;
      ++in_upper_;
      crossed(largest.vertex);
    }
    while (in_upper_ > in_lower_ + 1) {
      const PriceQueue::Offer least = upper_.top();
      upper_.remove(least.vertex);
      lower_.set(least.vertex, -least.price);
      --in_upper_;
      ++in_lower_;
      crossed(least.vertex);
    }
  }

  PriceQueue upper_;  // the least first
  PriceQueue lower_;  // by the negative: the largest first
  std::size_t in_upper_ = 0, in_lower_ = 0;
};

}  // namespace winnow
