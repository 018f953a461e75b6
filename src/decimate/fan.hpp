// The faces around a vertex in their order, where they are one fan, and what its removal into a
// neighbour does to them.
#pragma once

#include "decimate/tile_mesh.hpp"

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

namespace winnow {

// What a fan looks like from its vertex.
struct FanView {
  std::span<const Point> seen;  // the neighbours, in order, whichever way round
  bool closed = true;           // else the fan begins and ends at a boundary
  Point off{};                  // what rounding leaves unknown of each coordinate
  // Where the faces are no fan: the two neighbours of each.
  std::span<const std::array<std::uint32_t, 2>> loose{};

  [[nodiscard]] bool is_fan() const { return loose.empty(); }
  [[nodiscard]] std::size_t faces() const {
    if (!is_fan()) return loose.size();
    return closed ? seen.size() : seen.size() - 1;
  }
  // The two neighbours between which a face lies.
  [[nodiscard]] std::array<std::size_t, 2> ends(std::size_t face) const {
    if (!is_fan()) return {loose[face][0], loose[face][1]};
    return {face, face + 1 == seen.size() ? 0 : face + 1};
  }
};

class Fan {
 public:
  // `rounding`: of positions (base/rounding.hpp).
  explicit Fan(double rounding) : rounding_(rounding) {}

  // Whether `v` may be removed: its faces are a disk around it, or half of one at a boundary, and
  // it is neither locked nor a hub.
  bool find(const TileMesh& mesh, VertexNumber v);
  // The same of faces that are no fan, in whatever order.
  bool find_loose(const TileMesh& mesh, VertexNumber v);

  [[nodiscard]] std::span<const VertexNumber> neighbours() const { return ring_; }
  [[nodiscard]] FanView view() const { return {seen_, closed_, off_, loose_}; }

 private:
  bool extend();
  void look(const TileMesh& mesh, VertexNumber v);

  double rounding_;
  std::vector<VertexNumber> ring_;
  std::vector<Point> seen_;
  std::vector<std::pair<VertexNumber, VertexNumber>> rim_;  // the edges across from the vertex
  std::vector<std::array<std::uint32_t, 2>> loose_;
  Point off_{};
  bool closed_ = false;
};

// A face that leaves its plane.
struct TurnedFace {
  Point before, after;  // its normals, as long as twice its areas
  Point side;           // that stays
  double swept = 0;     // six times the volume between the two, with a sign
};

// each(face) for those that turn when the vertex goes to a neighbour. A neighbour that lies in the
// plane of a face, or next to it by no more than rounding, turns nothing.
template <typename Each>
void for_each_turned(const FanView& fan, std::size_t into, const Each& each) {
  const Point& to = fan.seen[into];
  const auto unknown = [&](const Point& area) {
    return fan.off[0] * std::abs(area[0]) + fan.off[1] * std::abs(area[1]) +
           fan.off[2] * std::abs(area[2]);
  };
  for (std::size_t i = 0; i < fan.faces(); ++i) {
    const auto [a, b] = fan.ends(i);
    if (a == into || b == into) continue;
    // The other faces of the tetrahedron that is swept.
    const Point first = cross(fan.seen[a], to);
    const Point second = cross(to, fan.seen[b]);
    const Point before = cross(fan.seen[a], fan.seen[b]);
    const double swept = dot(before, to);
    if (std::abs(swept) <= unknown(before) + unknown(first) + unknown(second)) continue;
    each(TurnedFace{before, before - first - second, fan.seen[b] - fan.seen[a], swept});
  }
}

// All faces of a fan.
struct FanShape {
  double area = 0;
  double perimeter = 0;  // through the neighbours; of an open fan with the line between its ends
  double spread =
      0;  // how much of the area normals cancel out: 0 where all faces lie in one plane, 1 at most

  // Of the mean angle between the faces and the plane that they are seen in best.
  [[nodiscard]] double cosine() const { return 1 - spread; }
  [[nodiscard]] double sine() const { return std::sqrt(spread * (2 - spread)); }
};
FanShape shape_of(const FanView& fan);

// How far the vertex of an open fan is from the line between its two neighbours along the boundary,
// which ends at these; 0 where that is no more than rounding.
double boundary_height(const FanView& fan);

// What is flat costs less than all that has a shape, at any scale: only its own order is left,
// short edges first.
inline double flat_cost(const FanView& fan, std::size_t into) {
  return 0x1p-700 * dot(fan.seen[into], fan.seen[into]);
}

}  // namespace winnow
