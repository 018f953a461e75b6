// Boxes that are asked which of them are nearest to a point.
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

  // Bytes in use at most for so many boxes, while it is made.
  static constexpr std::size_t memory(std::size_t boxes) {
    return boxes * (sizeof(Node) + 2 * sizeof(Box)) / 7 + sizeof(Node) + sizeof(Box) +
           boxes * (sizeof(Box) + sizeof(Point) + sizeof(std::uint32_t));
  }

  // each(number) for all boxes whose squared distance is no more than `limit`, the nearest mostly
  // first; each() may lower the limit. Farther than 10^18 times the longest side, none may be
  // found.
  template <typename Each>
  void for_each_within(const Point& point, const double& limit, const Each& each) const {
    if (levels_.empty()) return;
    std::array<float, 3> seen{};
    for (std::size_t axis = 0; axis < 3; ++axis)
      seen[axis] = static_cast<float>(scale_ * (point[axis] - middle_[axis]));
    visit(levels_.size() - 1, 0, seen, limit, each);
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

  void arrange(std::span<std::uint32_t> part, std::span<const Point> middles) const;
  std::vector<Node> nodes_of(std::vector<Box>& boxes) const;

  // Four times the squared distances.
  static std::array<float, group> squared_distances(const Node& node,
                                                    const std::array<float, 3>& point) {
    // Twice what is positive, without a branch: compilers use wide registers for it.
    const auto positive = [](float x) { return x + std::abs(x); };
    std::array<float, group> squared;
    for (std::size_t i = 0; i < group; ++i) {
      const float x = positive(std::abs(point[0] - node.middle[0][i]) - node.half[0][i]);
      const float y = positive(std::abs(point[1] - node.middle[1][i]) - node.half[1][i]);
      const float z = positive(std::abs(point[2] - node.middle[2][i]) - node.half[2][i]);
      squared[i] = x * x + y * y + z * z;
    }
    return squared;
  }

  template <typename Each>
  void visit(std::size_t level, std::size_t number, const std::array<float, 3>& point,
             const double& limit, const Each& each) const {
    std::array<float, group> squared = squared_distances(levels_[level][number], point);
    const auto most = [this, &limit] {
      // Never infinite: where there is no box, the distance is.
      return static_cast<float>(std::min(4 * (1 + slack) * scale_ * scale_ * limit,
                                         double{std::numeric_limits<float>::max()}));
    };
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
        each(std::size_t{order_[entered]});
      } else {
        visit(level - 1, entered, point, limit, each);
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
