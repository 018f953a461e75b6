#include "cluster/boundary_sum.hpp"

#include "base/vector.hpp"

namespace winnow {

namespace {

constexpr double steps = 1 << side_bits;      // in a cell
constexpr double shortest_square = 1.0 / 64;  // of what a boundary has to pass, in cells

Point as_point(const std::array<std::int64_t, 3>& sum, double scale) {
  return {static_cast<double>(sum[0]) / scale, static_cast<double>(sum[1]) / scale,
          static_cast<double>(sum[2]) / scale};
}

}  // namespace

// The line of all x with along x x = -moment.
std::array<double, 3> nearest_on_boundary(const BoundarySum& sum,
                                          const std::array<double, 3>& place) {
  const Point along = as_point(sum.along, steps);
  const double square = dot(along, along);
  if (square < shortest_square) return place;
  const Point foot = cross(along, as_point(sum.moment, steps * steps));
  const double walked = along[0] * place[0] + along[1] * place[1] + along[2] * place[2];
  return {(foot[0] + walked * along[0]) / square, (foot[1] + walked * along[1]) / square,
          (foot[2] + walked * along[2]) / square};
}

}  // namespace winnow
