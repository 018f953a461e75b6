// Angles between normals: their mean, and what 95 of 100 stay below.
#pragma once

#include <winnow/compare.hpp>

#include "base/exact_sum.hpp"
#include "base/vector.hpp"

#include <array>
#include <cstdint>
#include <vector>

namespace winnow {

class NormalDeviation {
 public:
  NormalDeviation() : hundredths_(18001) {}

  // Of two vectors of any length; one of none has no direction and is not counted.
  void add(const Point& one, const Point& other);
  void merge(const NormalDeviation& more);
  [[nodiscard]] CompareReport::Normals result() const;

 private:
  std::uint64_t count_ = 0;
  ExactSum degrees_;
  std::vector<std::uint64_t> hundredths_;  // how many angles lie in each hundredth of a degree
};

}  // namespace winnow
