// Some faces of a surface, and which of them are nearest to a point.
#pragma once

#include "base/box.hpp"
#include "base/vector.hpp"

#include <array>
#include <cstddef>
#include <limits>
#include <optional>
#include <vector>

namespace winnow {

class SurfacePatch {
 public:
  // A face that is not far from a point, to begin a search with.
  using Hint = std::size_t;
  static constexpr Hint unknown = std::numeric_limits<std::size_t>::max();

  // Bytes in use at most while it is made.
  static constexpr std::size_t bytes_a_face = sizeof(Triangle) + sizeof(Point) + sizeof(Box) + 64;

  // Searches are quick if faces that follow each other are close.
  explicit SurfacePatch(std::vector<Triangle> faces);

  // The squared distance to the nearest face, infinite if there is none. `near` becomes the nearest
  // face.
  double squared_distance(const Point& point, Hint& near) const;

  // Whether the nearest face is turned away from `normal`. Over a ridge several faces are nearest,
  // except for rounding: then, whether one of them is turned away.
  bool opposed(const Point& point, const Point& normal, Hint& near) const;

  // To the nearest face that is not turned away from `normal`; nothing if there is none.
  [[nodiscard]] std::optional<Point> way_to_facing(const Point& point, const Point& normal) const;

 private:
  static constexpr std::size_t group = 4;

  // The boxes of four faces, or of four nodes of the level below. Of each axis, `middle` is seen
  // from the middle of the patch, and `half` is half of the side, a little larger. It is negative
  // without a box.
  struct Node {
    std::array<std::array<float, group>, 3> middle, half;
  };

  static std::vector<Node> nodes_of(std::vector<Box>& boxes);
  [[nodiscard]] std::array<float, 3> seen_from_middle(const Point& point) const;
  // Four times those.
  static std::array<float, group> squared_distances(const Node& node,
                                                    const std::array<float, 3>& point);

  // each(face) for the faces whose boxes are no farther than `limit`, which each() may lower.
  template <typename Each>
  void for_each_within(const Point& point, const double& limit, const Each& each) const {
    visit(levels_.size() - 1, 0, seen_from_middle(point), limit, each);
  }
  template <typename Each>
  void visit(std::size_t level, std::size_t number, const std::array<float, 3>& point,
             const double& limit, const Each& each) const;

  [[nodiscard]] double squared_distance_of(std::size_t face, const Point& point) const;
  [[nodiscard]] bool turned_away(std::size_t face, const Point& normal) const {
    return dot(normal, normals_[face]) < 0;
  }

  std::vector<Triangle> faces_;
  std::vector<Point> normals_;  // as long as twice the area
  Point middle_{};
  std::vector<std::vector<Node>> levels_;  // the last has one node
};

}  // namespace winnow
