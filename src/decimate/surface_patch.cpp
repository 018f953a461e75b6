#include "decimate/surface_patch.hpp"

#include "base/closest_point.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace winnow {

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
// Squared distances that differ by no more than this part are equal, except for rounding.
constexpr double as_near = 1e-9;
// More than floats round by: boxes are larger by this part of their distance from the middle,
// limits by this part of themselves.
constexpr double slack = 1e-6;

}  // namespace

SurfacePatch::SurfacePatch(std::vector<Triangle> faces) : faces_(std::move(faces)) {
  if (faces_.empty()) return;
  Box all;
  for (const Triangle& t : faces_) all.add(t[0]);
  middle_ = 0.5 * (all.low + all.high);
  std::vector<Box> boxes(faces_.size());
  normals_.reserve(faces_.size());
  for (std::size_t f = 0; f < faces_.size(); ++f) {
    const Triangle& t = faces_[f];
    normals_.push_back(doubled_area(t));
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const double a = t[0][axis] - middle_[axis];
      const double b = t[1][axis] - middle_[axis];
      const double c = t[2][axis] - middle_[axis];
      boxes[f].low[axis] = std::min(a, std::min(b, c));
      boxes[f].high[axis] = std::max(a, std::max(b, c));
    }
  }
  do {
    levels_.push_back(nodes_of(boxes));
  } while (boxes.size() > 1);
}

// Leaves the boxes of the nodes themselves.
std::vector<SurfacePatch::Node> SurfacePatch::nodes_of(std::vector<Box>& boxes) {
  Node none;
  for (auto& middles : none.middle) middles.fill(0);
  for (auto& halves : none.half) halves.fill(-std::numeric_limits<float>::infinity());
  std::vector<Node> nodes((boxes.size() + group - 1) / group, none);
  for (std::size_t i = 0; i < boxes.size(); ++i) {
    const Box box = boxes[i];
    Node& node = nodes[i / group];
    Box& around = boxes[i / group];
    if (i % group == 0) around = box;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const double low = box.low[axis];
      const double high = box.high[axis];
      const double far = std::max(std::abs(low), std::abs(high));
      node.middle[axis][i % group] = static_cast<float>(0.5 * (low + high));
      node.half[axis][i % group] = static_cast<float>(0.5 * (high - low) + slack * far);
      around.low[axis] = std::min(around.low[axis], low);
      around.high[axis] = std::max(around.high[axis], high);
    }
  }
  boxes.resize(nodes.size());
  return nodes;
}

std::array<float, 3> SurfacePatch::seen_from_middle(const Point& point) const {
  const Point seen = point - middle_;
  return {static_cast<float>(seen[0]), static_cast<float>(seen[1]), static_cast<float>(seen[2])};
}

std::array<float, SurfacePatch::group> SurfacePatch::squared_distances(
    const Node& node, const std::array<float, 3>& point) {
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
void SurfacePatch::visit(std::size_t level, std::size_t number, const std::array<float, 3>& point,
                         const double& limit, const Each& each) const {
  const std::array<float, group> squared = squared_distances(levels_[level][number], point);
  const auto enter = [&](std::size_t i) {
    // Never infinite: where there is no box, the distance is.
    const double most = std::min(4 * (1 + slack) * limit, std::numeric_limits<double>::max());
    if (!(static_cast<double>(squared[i]) <= most)) return;
    if (level == 0) {
      each(number * group + i);
    } else {
      visit(level - 1, number * group + i, point, limit, each);
    }
  };
  // The nearest first: it may lower the limit.
  const auto nearest =
      static_cast<std::size_t>(std::min_element(squared.begin(), squared.end()) - squared.begin());
  enter(nearest);
  for (std::size_t i = 0; i < group; ++i) {
    if (i != nearest) enter(i);
  }
}

double SurfacePatch::squared_distance_of(std::size_t face, const Point& point) const {
  const Point away = point - closest_point(point, faces_[face]);
  return dot(away, away);
}

double SurfacePatch::squared_distance(const Point& point, Hint& near) const {
  if (faces_.empty()) return infinity;
  double least =
      near == unknown ? std::numeric_limits<double>::max() : squared_distance_of(near, point);
  for_each_within(point, least, [&](std::size_t face) {
    const double squared = squared_distance_of(face, point);
    if (squared < least) {
      least = squared;
      near = face;
    }
  });
  return least;
}

bool SurfacePatch::opposed(const Point& point, const Point& normal, Hint& near) const {
  if (faces_.empty()) return false;
  if (near == unknown) squared_distance(point, near);
  if (near == unknown) return false;  // at no distance that is a number
  // Faces of the other kind that are as near as the known one: mostly there is none.
  const bool known = turned_away(near, normal);
  double limit = (known ? 1 : 1 + as_near) * squared_distance_of(near, point);
  bool found = false;
  for_each_within(point, limit, [&](std::size_t face) {
    if (turned_away(face, normal) == known) return;
    const double squared = squared_distance_of(face, point);
    if (squared > limit) return;
    limit = squared;
    near = face;
    found = true;
  });
  if (!found) return known;
  // Then a face of the known kind that is nearer still.
  limit *= known ? 1 + as_near : 1 - as_near;
  bool nearer = false;
  for_each_within(point, limit, [&](std::size_t face) {
    if (nearer || turned_away(face, normal) != known) return;
    nearer = squared_distance_of(face, point) <= limit;
  });
  return nearer == known;
}

std::optional<Point> SurfacePatch::way_to_facing(const Point& point, const Point& normal) const {
  std::optional<Point> way;
  if (faces_.empty()) return way;
  double least = std::numeric_limits<double>::max();
  for_each_within(point, least, [&](std::size_t face) {
    if (turned_away(face, normal)) return;
    const Point there = closest_point(point, faces_[face]) - point;
    const double squared = dot(there, there);
    if (squared >= least) return;
    least = squared;
    way = there;
  });
  return way;
}

}  // namespace winnow
