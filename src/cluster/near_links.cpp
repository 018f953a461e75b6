#include "cluster/near_links.hpp"

#include <algorithm>
#include <numeric>

namespace winnow {

namespace {

// Up to so many points all pairs are tried.
constexpr std::size_t few_for_pairs = 8;

// The square of the least and of the largest distance between two boxes' points.
template <typename Node>
double least_squared(const Node& a, const Node& b) {
  Point gap{};
  for (std::size_t axis = 0; axis < 3; ++axis)
    gap[axis] = std::max({0.0, b.low[axis] - a.high[axis], a.low[axis] - b.high[axis]});
  return dot(gap, gap);
}

template <typename Node>
double largest_squared(const Node& a, const Node& b) {
  Point span{};
  for (std::size_t axis = 0; axis < 3; ++axis)
    span[axis] = std::max(b.high[axis] - a.low[axis], a.high[axis] - b.low[axis]);
  return dot(span, span);
}

}  // namespace

void NearLinks::find(std::span<const NumberedPoint> points, const Link& link) {
  if (points.size() < 2) return;
  parent_.resize(points.size());
  std::iota(parent_.begin(), parent_.end(), 0U);
  if (points.size() <= few_for_pairs) {
    for (std::uint32_t i = 0; i < points.size(); ++i) {
      for (std::uint32_t k = 0; k < i; ++k) {
        if (is_nearer(points[i].position, points[k].position, distance_)) unite(i, k);
      }
    }
  } else {
    leaves_.clear();
    nodes_.clear();
    for (std::uint32_t i = 0; i < points.size(); ++i) leaves_.push_back({points[i].position, i});
    nodes_.reserve(2 * points.size());
    join(nodes_[build(0, leaves_.size())]);
  }
  for (std::uint32_t i = 0; i < points.size(); ++i) {
    if (const std::uint32_t first = root(i); first != i)
      link(points[first].number, points[i].number);
  }
}

std::uint32_t NearLinks::build(std::size_t begin, std::size_t end) {
  progress_.check_cancelled();
  const auto number = static_cast<std::uint32_t>(nodes_.size());
  Node node{leaves_[begin].position,
            leaves_[begin].position,
            static_cast<std::uint32_t>(begin),
            {},
            end - begin == 1,
            false};
  for (std::size_t i = begin + 1; i < end; ++i) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      node.low[axis] = std::min(node.low[axis], leaves_[i].position[axis]);
      node.high[axis] = std::max(node.high[axis], leaves_[i].position[axis]);
    }
  }
  node.together = largest_squared(node, node) < squared_;
  nodes_.push_back(node);
  if (node.single) return number;
  const Point side = node.high - node.low;
  const auto axis =
      static_cast<std::size_t>(std::max_element(side.begin(), side.end()) - side.begin());
  const std::size_t middle = begin + (end - begin) / 2;
  const auto at = [&](std::size_t i) { return leaves_.begin() + static_cast<std::ptrdiff_t>(i); };
  std::nth_element(at(begin), at(middle), at(end), [axis](const Leaf& a, const Leaf& b) {
    return a.position[axis] < b.position[axis];
  });
  const std::uint32_t lower = build(begin, middle);
  const std::uint32_t upper = build(middle, end);
  nodes_[number].half = {lower, upper};
  return number;
}

void NearLinks::join(const Node& node) {
  if (node.single) return;
  join(nodes_[node.half[0]]);
  join(nodes_[node.half[1]]);
  if (node.together) {
    unite(leaves_[node.first].rank, leaves_[nodes_[node.half[1]].first].rank);
  } else {
    join(node.half[0], node.half[1]);
  }
}

void NearLinks::join(std::uint32_t a, std::uint32_t b) {
  progress_.check_cancelled();
  const Node& one = nodes_[a];
  const Node& other = nodes_[b];
  if (!(least_squared(one, other) < squared_)) return;
  if (one.together && other.together) {
    const std::uint32_t from = leaves_[one.first].rank;
    const std::uint32_t to = leaves_[other.first].rank;
    if (root(from) != root(to) && any_near(a, b)) unite(from, to);
    return;
  }
  const bool first = !one.together &&
                     (other.together || largest_squared(one, one) >= largest_squared(other, other));
  for (const std::uint32_t half : first ? one.half : other.half) {
    if (first) {
      join(half, b);
    } else {
      join(a, half);
    }
  }
}

bool NearLinks::any_near(std::uint32_t a, std::uint32_t b) const {
  progress_.check_cancelled();
  const Node& one = nodes_[a];
  const Node& other = nodes_[b];
  if (!(least_squared(one, other) < squared_)) return false;
  if (largest_squared(one, other) < squared_) return true;
  const bool first =
      !one.single && (other.single || largest_squared(one, one) >= largest_squared(other, other));
  if (first) return any_near(one.half[0], b) || any_near(one.half[1], b);
  return any_near(a, other.half[0]) || any_near(a, other.half[1]);
}

std::uint32_t NearLinks::root(std::uint32_t rank) {
  while (parent_[rank] != rank) rank = parent_[rank] = parent_[parent_[rank]];
  return rank;
}

void NearLinks::unite(std::uint32_t a, std::uint32_t b) {
  a = root(a);
  b = root(b);
  parent_[std::max(a, b)] = std::min(a, b);
}

}  // namespace winnow
