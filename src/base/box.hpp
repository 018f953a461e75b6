// A box along the axes.
#pragma once

#include "base/vector.hpp"

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

}  // namespace winnow
