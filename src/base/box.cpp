#include "base/box.hpp"

#include <algorithm>

namespace winnow {

void Box::add(const Point& point) {
  for (std::size_t axis = 0; axis < 3; ++axis) {
    low[axis] = empty ? point[axis] : std::min(low[axis], point[axis]);
    high[axis] = empty ? point[axis] : std::max(high[axis], point[axis]);
  }
  empty = false;
}

void Box::add(const Box& other) {
  if (other.empty) return;
  add(other.low);
  add(other.high);
}

double Box::longest_side() const {
  return std::max({high[0] - low[0], high[1] - low[1], high[2] - low[2]});
}

double Box::diagonal() const {
  return length(high - low);
}

}  // namespace winnow
