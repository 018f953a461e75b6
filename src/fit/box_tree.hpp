// Boxes that are asked which of them are near a point, or a box.
#pragma once

#include "base/box.hpp"
#include "base/vector.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <utility>
#include <vector>

namespace winnow {

// Eight boxes that lie close together, or eight nodes, are a node.
class BoxTree {
 public:
  explicit BoxTree(std::span<const Box> boxes);

  // Bytes in use at most for so many boxes.
  static constexpr std::size_t memory_made(std::size_t boxes) {
    return boxes * (sizeof(Node) / 7 + 1 + sizeof(std::uint32_t)) + 2 * sizeof(Node);
  }
  // The same while it is made.
  static constexpr std::size_t memory(std::size_t boxes) {
    return boxes * (sizeof(Node) + 2 * sizeof(Box)) / 7 + sizeof(Node) + sizeof(Box) +
           boxes * (sizeof(Box) + sizeof(Placed) + sizeof(std::uint32_t));
  }

  // each(number) for all boxes whose squared distance from `place` is no more than `limit`, the
  // nearest mostly first; each() may lower the limit, below 0 to end the search. Farther than 10^18
  // times the longest side, none may be found. `beyond`: none whose squared distance is no more.
  template <typename Each>
  void for_each_within(const Box& place, const double& limit, const Each& each,
                       double beyond = -1) const {
    if (levels_.empty()) return;
    Seen seen{};
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const double low = place.low[axis] - middle_[axis];
      const double high = place.high[axis] - middle_[axis];
      seen.middle[axis] = static_cast<float>(0.5 * scale_ * (low + high));
      seen.half[axis] = static_cast<float>((0.5 + slack) * scale_ * (high - low));
    }
    seen.beyond = beyond < 0 ? -1 : squared_seen(beyond);
    visit(levels_.size() - 1, 0, seen, limit, each);
  }
  template <typename Each>
  void for_each_within(const Point& point, const double& limit, const Each& each) const {
    for_each_within(Box{point, point, false}, limit, each);
  }

  // Of all boxes.
  [[nodiscard]] const Box& whole() const { return whole_; }

 private:
  static constexpr std::size_t group = 8;
  // More than floats round by: boxes are larger by this part of their distance from the middle,
  // limits by this part of themselves.
  static constexpr double slack = 1e-6;

  // Of each axis, seen from the middle of all, which are about as large as 1; half a side is
  // negative where there is no box.
  struct Node {
    std::array<std::array<float, group>, 3> middle, half;
  };
  // The place that is asked for.
  struct Seen {
    std::array<float, 3> middle, half;
    float beyond;
  };

  struct Placed {
    Point middle;
    std::uint32_t number;
  };
  static void arrange(std::span<Placed> part);
  std::vector<Node> nodes_of(std::vector<Box>& boxes) const;

  // Four times a squared distance. Never infinite: where there is no box, the distance is.
  [[nodiscard]] float squared_seen(double squared) const {
    return static_cast<float>(std::min(4 * (1 + slack) * scale_ * scale_ * squared,
                                       double{std::numeric_limits<float>::max()}));
  }
  // Four times the squared distances.
  static std::array<float, group> squared_distances(const Node& node, const Seen& seen) {
    // Twice what is positive, without a branch: compilers use wide registers for it.
    const auto positive = [](float x) { return x + std::abs(x); };
    std::array<float, group> squared;
    for (std::size_t i = 0; i < group; ++i) {
      const float x =
          positive(std::abs(seen.middle[0] - node.middle[0][i]) - (node.half[0][i] + seen.half[0]));
      const float y =
          positive(std::abs(seen.middle[1] - node.middle[1][i]) - (node.half[1][i] + seen.half[1]));
      const float z =
          positive(std::abs(seen.middle[2] - node.middle[2][i]) - (node.half[2][i] + seen.half[2]));
      squared[i] = x * x + y * y + z * z;
    }
    return squared;
  }

  template <typename Each>
  void visit(std::size_t level, std::size_t number, const Seen& seen, const double& limit,
             const Each& each) const {
    std::array<float, group> squared = squared_distances(levels_[level][number], seen);
    const auto most = [this, &limit] { return squared_seen(limit); };
    std::array<std::uint8_t, group> near;
    std::size_t count = 0;
    const float first_most = most();
    for (std::size_t i = 0; i < group; ++i) {
      near[count] = static_cast<std::uint8_t>(i);
      count += squared[i] <= first_most ? 1U : 0U;
    }
    // The nearest first: it may lower the limit.
    for (std::size_t k = 0; k < count; ++k) {
      std::size_t least = k;
      for (std::size_t i = k + 1; i < count; ++i) {
        if (squared[near[i]] < squared[near[least]]) least = i;
      }
      std::swap(near[k], near[least]);
      if (k > 0 && !(squared[near[k]] <= most())) return;
      const std::size_t entered = number * group + near[k];
      if (level == 0) {
        if (squared[near[k]] > seen.beyond) each(std::size_t{order_[entered]});
      } else {
        visit(level - 1, entered, seen, limit, each);
      }
    }
  }

  Box whole_;
  Point middle_{};
  double scale_ = 1;
  std::vector<std::uint32_t> order_;       // of the boxes
  std::vector<std::vector<Node>> levels_;  // the last has one node
};

}  // namespace winnow
