// What the common cost of all tiles will be, by those that are known: tiles need not be tried much
// further than that.
#pragma once

#include "decimate/cost_classes.hpp"
#include "stitch/collapse_log.hpp"

#include <cstddef>
#include <cstdint>
#include <limits>
#include <mutex>
#include <vector>

namespace winnow {

// For many threads at once. What it says hangs on which tiles were ready first.
class CostEstimate {
 public:
  static constexpr std::uint64_t fewest_tiles = 3;  // that say anything

  // `removed`: which part of the faces that can change a cut removes.
  explicit CostEstimate(double removed) : wanted_(removed), faces_(cost_classes) {}

  // Of a tile: faces that can change.
  void add(const std::vector<CollapseLog::Cost>& costs, std::uint64_t faces) {
    const std::scoped_lock lock(mutex_);
    std::uint64_t before = 0;
    for (const CollapseLog::Cost& entry : costs) {
      faces_[cost_class(entry.cost)] += entry.removed - before;
      before = entry.removed;
    }
    all_ += faces;
    ++tiles_;
  }

  // No less than what the cut through the known tiles costs; infinite where too few are known.
  [[nodiscard]] double cost() const {
    const std::scoped_lock lock(mutex_);
    auto left = static_cast<std::int64_t>(wanted_ * static_cast<double>(all_));
    for (std::size_t i = 0; i + 1 < cost_classes && tiles_ >= fewest_tiles; ++i) {
      left -= static_cast<std::int64_t>(faces_[i]);
      if (left <= 0) return least_of_cost_class(i + 1);
    }
    return std::numeric_limits<double>::infinity();
  }

 private:
  double wanted_;
  std::vector<std::uint64_t> faces_;  // that collapses of each class remove
  std::uint64_t all_ = 0;
  std::uint64_t tiles_ = 0;
  mutable std::mutex mutex_;
};

}  // namespace winnow
