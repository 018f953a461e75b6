#include "fit/box_tree.hpp"

#include <algorithm>
#include <cmath>

namespace winnow {

BoxTree::BoxTree(std::span<const Box> boxes) {
  if (boxes.empty()) return;
  for (const Box& box : boxes) whole_.add(box);
  middle_ = 0.5 * whole_.low + 0.5 * whole_.high;
  const double side = whole_.longest_side();
  if (side > 0) scale_ = std::ldexp(1.0, -std::clamp(std::ilogb(side), -1000, 500));
  std::vector<Placed> placed;
  placed.reserve(boxes.size());
  for (std::uint32_t i = 0; i < boxes.size(); ++i)
    placed.push_back({0.5 * boxes[i].low + 0.5 * boxes[i].high, i});
  arrange(placed);
  order_.reserve(boxes.size());
  std::vector<Box> level;
  level.reserve(boxes.size());
  for (const Placed& box : placed) {
    order_.push_back(box.number);
    level.push_back(boxes[box.number]);
  }
  do {
    levels_.push_back(nodes_of(level));
  } while (level.size() > 1);
}

// Halves the part across its longest side, so that each half is whole nodes, until they are single.
void BoxTree::arrange(std::span<Placed> part) {
  if (part.size() <= group) return;
  std::size_t node = group;
  while (node * group < part.size()) node *= group;
  Point low = part.front().middle;
  Point high = low;
  for (const Placed& box : part) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      low[axis] = std::min(low[axis], box.middle[axis]);
      high[axis] = std::max(high[axis], box.middle[axis]);
    }
  }
  const Point side = high - low;
  const auto axis =
      static_cast<std::size_t>(std::max_element(side.begin(), side.end()) - side.begin());
  const std::size_t nodes = (part.size() + node - 1) / node;
  const std::size_t first = nodes / 2 * node;
  std::nth_element(
      part.begin(), part.begin() + static_cast<std::ptrdiff_t>(first), part.end(),
      [axis](const Placed& a, const Placed& b) { return a.middle[axis] < b.middle[axis]; });
  arrange(part.first(first));
  arrange(part.subspan(first));
}

// Leaves the boxes of the nodes themselves.
std::vector<BoxTree::Node> BoxTree::nodes_of(std::vector<Box>& boxes) const {
  Node none;
  for (auto& middles : none.middle) middles.fill(0);
  for (auto& halves : none.half) halves.fill(-std::numeric_limits<float>::infinity());
  std::vector<Node> nodes((boxes.size() + group - 1) / group, none);
  for (std::size_t i = 0; i < boxes.size(); ++i) {
    const Box box = boxes[i];
    Node& node = nodes[i / group];
    Box& around = boxes[i / group];
    if (i % group == 0) {
      around = box;
    } else {
      around.add(box);
    }
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const double low = scale_ * (box.low[axis] - middle_[axis]);
      const double high = scale_ * (box.high[axis] - middle_[axis]);
      const double far = std::max(std::abs(low), std::abs(high));
      node.middle[axis][i % group] = static_cast<float>(0.5 * (low + high));
      node.half[axis][i % group] = static_cast<float>(0.5 * (high - low) + slack * far);
    }
  }
  boxes.resize(nodes.size());
  return nodes;
}

}  // namespace winnow
