#include "cluster/representative.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace winnow {

namespace {

constexpr double fraction_scale = 1 << fraction_bits;
constexpr double normal_scale = 1 << normal_bits;

// Pulls the minimiser towards the mean where the planes leave it free (along an edge, on a flat
// face), as a part of the planes' total weight. 10^-3 to 10^-2 are equally good by measurement
// (bench/RESULTS.md); below, nearly flat cells throw their vertex to the cell's wall.
constexpr double pull = 5e-3;

// What a boundary has to be off, in cells: more than its sums are rounded by.
constexpr double least_step = 0x1p-12;

// The number of type Real nearest to `coordinate` that is in the part of its cell by Grid's own
// formula. There is one: the coordinates of the corners in it are of that type. A few steps reach
// it; far from the origin, where the lattice is finer than a float, they are steps of the float.
template <typename Real>
double round_into_cell(double coordinate, const Grid& grid, std::size_t axis,
                       const SplitCells::Part& part) {
  auto value = static_cast<Real>(coordinate);
  constexpr Real infinity = std::numeric_limits<Real>::infinity();
  for (int step = 0; step < 64; ++step) {
    const double found = grid.rounded_place(static_cast<double>(value), axis) - part.cell[axis];
    if (found < part.low[axis]) {
      value = std::nextafter(value, infinity);
    } else if (found >= part.low[axis] + part.size) {
      value = std::nextafter(value, -infinity);
    } else {
      break;
    }
  }
  return static_cast<double>(value);
}

}  // namespace

WholeCell::WholeCell(CellKey key, const SplitCells* split) : key_(key) {
  if (split != nullptr) {
    part_ = split->part_of(key);
  } else {
    part_.cell = morton_cell(key);
  }
}

void WholeCell::add(const CellSum& sum) {
  used_ |= (sum.weight & CellSum::used_bit) != 0;
  weight_ += static_cast<Int128>(sum.weight & ~CellSum::used_bit);
  for (std::size_t axis = 0; axis < 3; ++axis) {
    position_[axis] += sum.position[axis];
    normal_[axis] += sum.normal[axis];
  }
}

void WholeCell::add(const QuadricCellSum& sum) {
  add(static_cast<const CellSum&>(sum));
  for (std::size_t i = 0; i < 5; ++i) squares_[i] += sum.squares[i];
  for (std::size_t i = 0; i < 3; ++i) moment_[i] += sum.moment[i];
}

std::array<double, 3> WholeCell::mean_place() const {
  const double scale = static_cast<double>(weight_) * fraction_scale;
  std::array<double, 3> place{};
  for (std::size_t axis = 0; axis < 3; ++axis)
    place[axis] = static_cast<double>(position_[axis]) / scale;
  return place;
}

// Garland and Heckbert's quadric of the planes n·x = d, each with its corner's weight: minimises
// the mean of (n·x - d)^2 plus pull * |x - mean|^2.
std::array<double, 3> WholeCell::quadric_place(const std::array<double, 3>& mean) const {
  const double scale = static_cast<double>(weight_) * normal_scale;
  Quadric planes;  // seen from the cell's middle
  planes.xx = static_cast<double>(squares_[0]) / scale;
  planes.xy = static_cast<double>(squares_[1]) / scale;
  planes.xz = static_cast<double>(squares_[2]) / scale;
  planes.yy = static_cast<double>(squares_[3]) / scale;
  planes.yz = static_cast<double>(squares_[4]) / scale;
  // The squares of a unit normal add up to one; corners without a normal leave a little less.
  planes.zz = std::max(0.0, 1 - planes.xx - planes.yy);
  const Point middle{0.5, 0.5, 0.5};
  for (std::size_t axis = 0; axis < 3; ++axis)
    planes.b[axis] = static_cast<double>(moment_[axis]) / scale;
  Point place = middle + lowest_point(planes, pull, mean - middle);
  // Rounded sums of planes that hardly differ can leave nothing to solve.
  if (!finite(place)) return mean;
  for (std::size_t axis = 0; axis < 3; ++axis)
    place[axis] = std::clamp(place[axis], part_.low[axis], part_.low[axis] + part_.size);
  return place;
}

void WholeCell::keep_to_boundary(std::array<double, 3>& place) const {
  const std::array<double, 3> seen{place[0] - 0.5, place[1] - 0.5, place[2] - 0.5};
  const std::array<double, 3> near = nearest_on_boundary(boundary_, seen);
  // A vertex that is alone in its cell stays, to the bit.
  double off = 0;
  for (std::size_t axis = 0; axis < 3; ++axis)
    off = std::max(off, std::abs(near[axis] - seen[axis]));
  if (off < least_step) return;
  for (std::size_t axis = 0; axis < 3; ++axis)
    place[axis] = std::clamp(near[axis] + 0.5, part_.low[axis], part_.low[axis] + part_.size);
}

Quadric WholeCell::quadric(const Grid& grid, const Point& position) const {
  const double scale = static_cast<double>(weight_) * normal_scale;
  const double area = static_cast<double>(weight_) / (1 << area_bits) * grid.cell * grid.cell;
  std::array<double, 5> a{};
  for (std::size_t i = 0; i < 5; ++i) a[i] = area * (static_cast<double>(squares_[i]) / scale);
  Quadric sum;
  sum.xx = a[0];
  sum.xy = a[1];
  sum.xz = a[2];
  sum.yy = a[3];
  sum.yz = a[4];
  sum.zz = std::max(0.0, area - sum.xx - sum.yy);
  Point middle{};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    middle[axis] = grid.origin[axis] + (part_.cell[axis] + 0.5) * grid.cell;
    sum.b[axis] = area * grid.cell * (static_cast<double>(moment_[axis]) / scale);
  }
  sum.b = sum.b - sum.times(position - middle);
  if (area > 0) sum.c = std::max(0.0, -sum.at(lowest_point(sum, pull * area, {})));
  return sum;
}

CellState WholeCell::state(const Grid& grid, const Point& position) const {
  CellState state;
  state.planes = quadric(grid, position);
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const double low = grid.origin[axis] + (part_.cell[axis] + part_.low[axis]) * grid.cell;
    state.low[axis] = outwards(low - position[axis], -1);
    state.high[axis] = outwards(low + part_.size * grid.cell - position[axis], 1);
  }
  return state;
}

IndexedVertex WholeCell::vertex(const ClusterSettings& settings) const {
  IndexedVertex vertex;
  vertex.key = key_;
  std::array<double, 3> place = mean_place();
  if (settings.placement == Placement::quadric) place = quadric_place(place);
  keep_to_boundary(place);
  const double scale = static_cast<double>(weight_) * normal_scale;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    // A little off the upper wall: what rounds up to it belongs to the next cell.
    place[axis] = std::min(place[axis], part_.low[axis] + part_.size - 2 / fraction_scale);
    const double coordinate =
        settings.grid.origin[axis] + (part_.cell[axis] + place[axis]) * settings.grid.cell;
    vertex.position[axis] = settings.double_positions
                                ? round_into_cell<double>(coordinate, settings.grid, axis, part_)
                                : round_into_cell<float>(coordinate, settings.grid, axis, part_);
    vertex.normal[axis] = static_cast<float>(static_cast<double>(normal_[axis]) / scale);
  }
  return vertex;
}

}  // namespace winnow
