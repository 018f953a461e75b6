#include "cluster/boundary_sum.hpp"

#include "base/vector.hpp"
#include "cluster/kernel/corner_kernel.hpp"

#include <cmath>
#include <cstdlib>

namespace winnow {

namespace {

constexpr unsigned step_bits = 16;
constexpr double steps = 1 << step_bits;  // in a cell
// So that 2^22 sides are summed up without wrapping around.
constexpr std::int64_t farthest = 8 << step_bits;
constexpr double shortest_square = 1.0 / 64;  // of what a boundary has to pass, in cells

std::int64_t wrapped_sum(std::int64_t a, std::int64_t b) {
  return static_cast<std::int64_t>(static_cast<std::uint64_t>(a) + static_cast<std::uint64_t>(b));
}

Point as_point(const std::array<std::int64_t, 3>& sum, double scale) {
  return {static_cast<double>(sum[0]) / scale, static_cast<double>(sum[1]) / scale,
          static_cast<double>(sum[2]) / scale};
}

}  // namespace

void BoundarySum::add(const BoundarySum& more) {
  for (std::size_t axis = 0; axis < 3; ++axis) {
    along[axis] = wrapped_sum(along[axis], more.along[axis]);
    moment[axis] = wrapped_sum(moment[axis], more.moment[axis]);
  }
}

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

// A side counts where it ends in the cell, but not where its other end is far away: such a cell has
// no other boundary to be placed by.
void BoundaryCache::add_sides(PackedCell of, const std::array<PackedCell, 3>& cell,
                              const LatticeFace& place, BoundarySum& sum) {
  const std::size_t inside = cell[0] == of ? 0 : cell[1] == of ? 1 : 2;
  std::array<std::array<std::int64_t, 3>, 3> seen{};
  std::array<bool, 3> near{};
  for (std::size_t corner = 0; corner < 3; ++corner) {
    near[corner] = true;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const std::int64_t middle = (place[inside][axis] >> fraction_bits << fraction_bits) +
                                  (std::int64_t{1} << (fraction_bits - 1));
      seen[corner][axis] = (place[corner][axis] - middle) >> (fraction_bits - step_bits);
      near[corner] = near[corner] && std::abs(seen[corner][axis]) <= farthest;
    }
  }
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t j = (i + 1) % 3;
    if ((cell[i] != of && cell[j] != of) || !near[i] || !near[j]) continue;
    const std::array<std::int64_t, 3>& a = seen[i];
    const std::array<std::int64_t, 3>& b = seen[j];
    sum.add({of,
             {b[0] - a[0], b[1] - a[1], b[2] - a[2]},
             {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]}});
  }
}

}  // namespace winnow
