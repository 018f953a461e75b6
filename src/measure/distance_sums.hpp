// Mean, root mean square and maximum of distances, whatever the order in which they come.
#pragma once

#include <winnow/compare.hpp>

#include "base/exact_sum.hpp"
#include "base/vector.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace winnow {

class DistanceSums {
 public:
  // Of a sample, by its square: counts for mean, root mean square and maximum.
  void add(double squared, const Point& at) {
    ++samples_;
    sum_.add(std::sqrt(squared));
    squares_.add(squared);
    add_to_maximum(squared, at);
  }

  void add_to_maximum(double squared, const Point& at) {
    if (squared < largest_ || (squared == largest_ && !(at < worst_))) return;
    largest_ = squared;
    worst_ = at;
  }

  [[nodiscard]] std::uint64_t samples() const { return samples_; }
  // What a distance must reach to change the maximum.
  [[nodiscard]] double largest_squared() const { return largest_; }
  [[nodiscard]] const Point& worst() const { return worst_; }

  void merge(const DistanceSums& other) {
    samples_ += other.samples_;
    sum_.merge(other.sum_);
    squares_.merge(other.squares_);
    if (other.largest_ >= 0) add_to_maximum(other.largest_, other.worst_);
  }

  [[nodiscard]] Distances distances() const {
    Distances result;
    result.max = std::sqrt(std::max(0.0, largest_));
    if (samples_ == 0) return result;
    result.mean = sum_.value() / static_cast<double>(samples_);
    result.rms = std::sqrt(squares_.value() / static_cast<double>(samples_));
    return result;
  }

 private:
  std::uint64_t samples_ = 0;
  ExactSum sum_, squares_;
  double largest_ = -1;
  Point worst_{};
};

}  // namespace winnow
