// What the common cost of all tiles will be, by those that are known: tiles need not be tried much
// further than that.
#pragma once

#include "stitch/collapse_log.hpp"

#include <bit>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <mutex>
#include <vector>

namespace winnow {

// For many threads at once. What it says hangs on which tiles were ready first.
class CostEstimate {
 public:
  // `removed`: which part of the faces that can change a cut removes.
  explicit CostEstimate(double removed) : wanted_(removed), faces_(classes) {}

  // Of a tile: faces that can change.
  void add(const std::vector<CollapseLog::Cost>& costs, std::uint64_t faces) {
    const std::scoped_lock lock(mutex_);
    std::uint64_t before = 0;
    for (const CollapseLog::Cost& entry : costs) {
      faces_[class_of(entry.cost)] += entry.removed - before;
      before = entry.removed;
    }
    all_ += faces;
    ++tiles_;
  }

  // No less than what the cut through the known tiles costs; infinite where too few are known.
  [[nodiscard]] double cost() const {
    const std::scoped_lock lock(mutex_);
    auto left = static_cast<std::int64_t>(wanted_ * static_cast<double>(all_));
    for (std::size_t i = 0; i + 1 < classes && tiles_ >= fewest_tiles; ++i) {
      left -= static_cast<std::int64_t>(faces_[i]);
      if (left <= 0) return std::bit_cast<double>(std::uint64_t{i + 1} << class_bits);
    }
    return std::numeric_limits<double>::infinity();
  }

 private:
  static constexpr std::uint64_t fewest_tiles = 3;
  // Costs of a class differ by less than a sixteenth.
  static constexpr unsigned class_bits = 48;
  static constexpr std::size_t classes = std::size_t{1} << (63 - class_bits);
  static std::size_t class_of(double cost) {
    return static_cast<std::size_t>(std::bit_cast<std::uint64_t>(cost + 0.0) >> class_bits);
  }

  double wanted_;
  std::vector<std::uint64_t> faces_;  // that collapses of each class remove
  std::uint64_t all_ = 0;
  std::uint64_t tiles_ = 0;
  mutable std::mutex mutex_;
};

}  // namespace winnow
