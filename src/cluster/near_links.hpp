// Which points of a few hang together by steps shorter than a distance.
#pragma once

#include "base/progress.hpp"
#include "base/vector.hpp"

#include <array>
#include <cstdint>
#include <functional>
#include <span>
#include <vector>

namespace winnow {

struct NumberedPoint {
  std::uint64_t number;
  Point position;
};

// The one test that decides: computed as it stands, in doubles.
inline bool is_nearer(const Point& a, const Point& b, double distance) {
  const Point step = a - b;
  return dot(step, step) < distance * distance;
}

// Points are halved again and again into a tree of boxes. Points in a box whose diagonal is below
// the distance hang together without being looked at one by one. So many points near each other
// cost no more than a sort. All bounds are rounded as is_nearer() rounds, so they never disagree.
class NearLinks {
 public:
  NearLinks(double distance, const ProgressMeter& progress)
      : distance_(distance), squared_(distance * distance), progress_(progress) {}

  // What a point takes while links are found, the point itself included.
  static constexpr std::uint64_t bytes_a_point = 256;

  // link(first, other) for each point that hangs together with one of a lower number; `first` is
  // the lowest of all of them. Points come in ascending order of their numbers, at most 2^31.
  using Link = std::function<void(std::uint64_t first, std::uint64_t other)>;
  void find(std::span<const NumberedPoint> points, const Link& link);

 private:
  struct Leaf {
    Point position;
    std::uint32_t rank;  // among the points
  };
  struct Node {
    Point low, high;
    std::uint32_t first;                // a leaf
    std::array<std::uint32_t, 2> half;  // nodes; of a single point none
    bool single;
    bool together;  // all its points hang together
  };

  std::uint32_t build(std::size_t begin, std::size_t end);
  void join(const Node& node);
  void join(std::uint32_t a, std::uint32_t b);
  [[nodiscard]] bool any_near(std::uint32_t a, std::uint32_t b) const;
  std::uint32_t root(std::uint32_t rank);
  void unite(std::uint32_t a, std::uint32_t b);

  double distance_, squared_;
  const ProgressMeter& progress_;
  std::vector<Leaf> leaves_;
  std::vector<Node> nodes_;
  std::vector<std::uint32_t> parent_;  // by rank; never above its own
};

}  // namespace winnow
