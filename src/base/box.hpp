// A box along the axes.
#pragma once

#include "base/vector.hpp"

#include <cstddef>

namespace winnow {

// Around finite points; empty until one was added.
struct Box {
  Point low{}, high{};
  bool empty = true;

  void add(const Point& point);
  void add(const Box& other);
  [[nodiscard]] double longest_side() const;
  [[nodiscard]] double diagonal() const;
};

// Whether two boxes have a point in common; of anything with a lowest and a highest corner.
template <typename A, typename B>
bool boxes_meet(const A& a, const B& b) {
  for (std::size_t axis = 0; axis < 3; ++axis) {
    if (!(a.low[axis] <= b.high[axis] && b.low[axis] <= a.high[axis])) return false;
  }
  return true;
}

}  // namespace winnow
