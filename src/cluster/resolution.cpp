#include "cluster/resolution.hpp"

#include "base/hash.hpp"
#include "base/logarithm.hpp"
#include "base/per_slot.hpp"
#include "cluster/kernel/position_kernel.hpp"
#include "read/for_each_batch.hpp"

#include <algorithm>
#include <bit>
#include <cmath>

namespace winnow {

namespace {

constexpr std::uint64_t crude_points = 1 << 15;
// A clustered surface has about two faces a vertex, as any closed triangle mesh.
constexpr double faces_a_cell = 2;
// Of fewer points nothing is said to lie far off; of more, what lies so many times what most of
// them take.
constexpr std::size_t few_points = 100;
constexpr double far_off = 64;
// Far enough to ask whether faces use what lies there.
constexpr double far_for_faces = 4;
constexpr double largest_edge = 1.001;  // of the box's longest side: all in one cell

Point point_at(const PositionView& view, std::size_t i) {
  return {view.axis[0][i], view.axis[1][i], view.axis[2][i]};
}

PositionInput input_of(const PositionView& view) {
  return {{view.axis[0], view.axis[1], view.axis[2]}, view.count};
}

void add_to_box(const PositionKernel& kernel, const PositionView& view, Box& box) {
  if (view.count == 0) return;
  double low[3];
  double high[3];
  if (kernel.box(input_of(view), low, high)) {
    return box.add(Box{{low[0], low[1], low[2]}, {high[0], high[1], high[2]}, false});
  }
  for (std::size_t i = 0; i < view.count; ++i) {
    if (finite(point_at(view, i))) box.add(point_at(view, i));
  }
}

// The corners of faces that no status keeps out, if all three are finite.
void add_to_box(const PositionKernel& kernel, const FaceBatch& faces, Box& box) {
  std::array<std::array<double, FaceBatch::capacity>, 3> corner;
  bool finite_all = faces.all_good;
  Box all;
  for (std::size_t c = 0; c < 3 && finite_all; ++c) {
    PositionInput input{{}, faces.count};
    for (std::size_t axis = 0; axis < 3; ++axis) {
      input.axis[axis] = faces.position[c][axis].data();
      if (!faces.single) continue;
      std::copy_n(faces.single_position[c][axis].begin(), faces.count, corner[axis].begin());
      input.axis[axis] = corner[axis].data();
    }
    double low[3];
    double high[3];
    finite_all = kernel.box(input, low, high);
    if (finite_all) all.add(Box{{low[0], low[1], low[2]}, {high[0], high[1], high[2]}, false});
  }
  if (finite_all) return box.add(all);
  for (std::size_t i = 0; i < faces.count; ++i) {
    if (faces.status[i] != FaceStatus::good) continue;
    const Triangle face{faces.corner(0, i), faces.corner(1, i), faces.corner(2, i)};
    if (!finite(face[0]) || !finite(face[1]) || !finite(face[2])) continue;
    for (const Point& p : face) box.add(p);
  }
}

// One position out of every `step`, at a place in its stretch that a hash picks, so that rows of a
// scanner are not hit in step. Positions without vertices are those of first corners: enough to
// meet every vertex.
void pick_points(const PositionView& view, std::uint64_t step, std::vector<Point>& points) {
  if (view.corner != 0) return;
  const std::uint64_t end = view.first + view.count;
  for (std::uint64_t stretch = view.first / step; stretch * step < end; ++stretch) {
    const std::uint64_t number = stretch * step + mixed_hash(stretch) % step;
    if (number < view.first || number >= end) continue;
    const Point point = point_at(view, number - view.first);
    if (finite(point)) points.push_back(point);
  }
}

std::uint64_t hash_cell(const Point& point, const Grid& grid) {
  std::array<std::uint32_t, 3> cell{};
  for (std::size_t axis = 0; axis < 3; ++axis)
    cell[axis] = static_cast<std::uint32_t>(grid.place(point[axis], axis));
  return mixed_hash(pack_cell(cell[0], cell[1], cell[2]));
}

std::size_t distinct_cells(const std::vector<Point>& points, const Grid& grid) {
  std::vector<std::uint64_t> hashes;
  hashes.reserve(points.size());
  for (const Point& point : points) hashes.push_back(hash_cell(point, grid));
  std::sort(hashes.begin(), hashes.end());
  return static_cast<std::size_t>(std::unique(hashes.begin(), hashes.end()) - hashes.begin());
}

struct PickedPoints {
  Box box;                    // of all positions
  std::vector<Point> points;  // some of them, in any order
};

PickedPoints pick_points(Job& job, MeshReader& reader, std::uint64_t positions) {
  PerSlot<PickedPoints> slots(job.threads, [] { return std::make_unique<PickedPoints>(); });
  const std::uint64_t step = std::max<std::uint64_t>(1, positions / crude_points);
  const PositionKernel& kernel = best_position_kernel();
  for_each_position_batch(job, reader, [&](const PositionView& view) {
    PickedPoints& part = slots.local();
    add_to_box(kernel, view, part.box);
    pick_points(view, step, part.points);
  });
  PickedPoints all;
  for (const PickedPoints* part : slots.all()) {
    all.box.add(part->box);
    all.points.insert(all.points.end(), part->points.begin(), part->points.end());
  }
  return all;
}

// Counts different values by the share of a bitmap that their hashes leave empty (linear counting:
// Whang, Vander-Zanden, Taylor 1990); with a bit and more for each value its error is far below a
// percent.
class DistinctCounter {
 public:
  static constexpr std::uint64_t most_bits = std::uint64_t{1} << 25;

  static std::uint64_t bits_for(double expected) {
    const double wanted = std::min(4 * expected, static_cast<double>(most_bits));
    return std::bit_ceil(std::max<std::uint64_t>(4096, static_cast<std::uint64_t>(wanted)));
  }

  explicit DistinctCounter(std::uint64_t bits)
      : words_(bits / 64), shift_(64 - static_cast<unsigned>(std::countr_zero(bits))) {}

  void add(std::uint64_t hash) {
    words_[hash >> shift_ >> 6] |= std::uint64_t{1} << (hash >> shift_ & 63);
  }

  void merge(const DistinctCounter& other) {
    for (std::size_t i = 0; i < words_.size(); ++i) words_[i] |= other.words_[i];
  }

  [[nodiscard]] double count() const {
    std::uint64_t set = 0;
    for (const std::uint64_t word : words_) set += static_cast<std::uint64_t>(std::popcount(word));
    const double bits = 64 * static_cast<double>(words_.size());
    const double empty = std::max(1.0, bits - static_cast<double>(set));
    return std::max(1.0, -bits * natural_logarithm(empty / bits));
  }

 private:
  std::vector<std::uint64_t> words_;
  unsigned shift_;
};

// Cells of the finite positions.
void count_positions(const PositionKernel& kernel, const PositionView& view, const Grid& grid,
                     DistinctCounter& counter) {
  const double origin[3] = {grid.origin[0], grid.origin[1], grid.origin[2]};
  alignas(64) std::array<std::int64_t, FaceBatch::capacity> cell;
  kernel.cells(input_of(view), origin, grid.inverse, cell.data());
  // Neighbours are mostly in one cell: those that are not are told apart without a branch.
  std::size_t kept = 0;
  std::int64_t last = -1;
  for (std::size_t i = 0; i < view.count; ++i) {
    const std::int64_t next = cell[i];
    cell[kept] = next;
    kept += static_cast<std::size_t>((next != last) & (next >= 0));
    last = next;
  }
  for (std::size_t i = 0; i < kept; ++i)
    counter.add(mixed_hash(static_cast<std::uint64_t>(cell[i])));
}

}  // namespace

Box measure_box(Job& job, MeshReader& reader) {
  job.progress.begin("measure", 0, "positions");
  PerSlot<Box> boxes(job.threads, [] { return std::make_unique<Box>(); });
  const PositionKernel& kernel = best_position_kernel();
  for_each_position_batch(
      job, reader, [&](const PositionView& view) { add_to_box(kernel, view, boxes.local()); });
  Box box;
  for (const Box* part : boxes.all()) box.add(*part);
  return box;
}

Box measure_box_of_faces(Job& job, MeshReader& reader) {
  job.progress.begin("measure", reader.facts().faces.value_or(0), "faces");
  PerSlot<Box> boxes(job.threads, [] { return std::make_unique<Box>(); });
  const PositionKernel& kernel = best_position_kernel();
  reader.begin_faces();
  for_each_face_batch(
      job, reader, [&](const FaceBatch& batch) { add_to_box(kernel, batch, boxes.local()); }, {});
  Box box;
  for (const Box* part : boxes.all()) box.add(*part);
  return box;
}

namespace {

// All but a few on either side, and as much again around them.
Box box_of_most(const PickedPoints& picked) {
  Box most = picked.box;
  std::vector<double> along;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    along.clear();
    for (const Point& point : picked.points) along.push_back(point[axis]);
    const auto cut = static_cast<std::ptrdiff_t>(along.size() / 200 + 1);
    const auto lower = along.begin() + cut, upper = along.end() - 1 - cut;
    std::nth_element(along.begin(), lower, along.end());
    const double low = *lower;  // read before the next call moves it
    std::nth_element(lower, upper, along.end());
    const double high = *upper;
    most.low[axis] = std::max(most.low[axis], low - (high - low));
    most.high[axis] = std::min(most.high[axis], high + (high - low));
  }
  return most;
}

bool reaches_beyond(const Box& box, const Box& most, double factor) {
  const double side = most.longest_side();
  return side > 0 && side * factor < box.longest_side();
}

// Of all positions, or of those that faces use where some lie far off; then the picked ones outside
// are dropped.
void take_surface(Job& job, MeshReader& reader, PickedPoints& picked) {
  const bool few = picked.points.size() < few_points;
  if (!few && !reaches_beyond(picked.box, box_of_most(picked), far_for_faces)) return;
  picked.box = measure_box_of_faces(job, reader);
  const Box& box = picked.box;
  std::erase_if(picked.points, [&](const Point& p) {
    return box.empty || p[0] < box.low[0] || p[1] < box.low[1] || p[2] < box.low[2] ||
           p[0] > box.high[0] || p[1] > box.high[1] || p[2] > box.high[2];
  });
}

}  // namespace

MostPositions measure_most(Job& job, MeshReader& reader, std::uint64_t positions) {
  if (positions == 0) return {measure_box(job, reader), {}};
  job.progress.begin("measure", positions, "positions");
  PickedPoints picked = pick_points(job, reader, positions);
  if (picked.points.size() < few_points) return {picked.box, std::move(picked.points)};
  const Box most = box_of_most(picked);
  return {reaches_beyond(picked.box, most, far_off) ? most : picked.box, std::move(picked.points)};
}

Box measure_box_of_most(Job& job, MeshReader& reader, std::uint64_t positions) {
  return measure_most(job, reader, positions).box;
}

Box measure_surface(Job& job, MeshReader& reader, std::uint64_t positions) {
  job.progress.begin("measure", positions, "positions");
  PickedPoints picked = pick_points(job, reader, positions);
  take_surface(job, reader, picked);
  return picked.box;
}

std::uint64_t CellCounts::memory(unsigned threads) {
  return threads * sizes * DistinctCounter::most_bits / 8 + 4 * crude_points * sizeof(Point);
}

CellCounts::CellCounts(Job& job, MeshReader& reader, std::uint64_t positions,
                       std::uint64_t wanted_faces) {
  job.progress.begin("sample", positions, "positions");
  PickedPoints picked = pick_points(job, reader, positions);
  take_surface(job, reader, picked);
  box_ = picked.box;
  if (box_.empty || !(box_.longest_side() > 0)) return;
  const double cells = std::max(1.0, static_cast<double>(wanted_faces) / faces_a_cell);
  count_cells(job, reader, crude_cell(picked.points, cells), cells);
}

// From points picked blindly: good while cells hold many of them; smaller cells are extrapolated,
// as on a surface four times as many are half as wide.
double CellCounts::crude_cell(const std::vector<Point>& points, double cells) const {
  const double wanted = std::min(cells, std::max(1.0, static_cast<double>(points.size()) / 16));
  double low = box_.longest_side() / (axis_cells / 2);
  double high = box_.longest_side() * largest_edge;
  while (high > low * 1.02) {
    const double middle = std::sqrt(low * high);
    const auto found = static_cast<double>(distinct_cells(points, Grid::over(box_, middle)));
    (found > wanted ? low : high) = middle;
  }
  return high * std::sqrt(wanted / cells);
}

void CellCounts::count_cells(Job& job, MeshReader& reader, double crude, double cells) {
  constexpr std::array<double, sizes> around{0.75, 1.0, 1.3};
  std::array<Grid, sizes> grids;
  for (std::size_t i = 0; i < sizes; ++i) {
    const double edge = std::clamp(crude * around[i], box_.longest_side() / (axis_cells / 2),
                                   box_.longest_side() * largest_edge);
    grids[i] = Grid::over(box_, edge);
    edge_[i] = natural_logarithm(edge);
  }
  const std::uint64_t bits = DistinctCounter::bits_for(2 * cells);
  const PositionKernel& kernel = best_position_kernel();
  using Counters = std::vector<DistinctCounter>;
  PerSlot<Counters> slots(job.threads,
                          [&] { return std::make_unique<Counters>(sizes, DistinctCounter(bits)); });
  for_each_position_batch(
      job, reader,
      [&](const PositionView& view) {
        if (view.corner != 0) return;
        Counters& counters = slots.local();
        for (std::size_t i = 0; i < sizes; ++i)
          count_positions(kernel, view, grids[i], counters[i]);
      },
      PassCorners::first);
  Counters all(sizes, DistinctCounter(bits));
  for (const Counters* counters : slots.all()) {
    for (std::size_t i = 0; i < sizes; ++i) all[i].merge((*counters)[i]);
  }
  for (std::size_t i = 0; i < sizes; ++i) occupied_[i] = natural_logarithm(all[i].count());
}

double CellCounts::expected_faces(double cell) const {
  // Straight lines between the three sizes, both ways on with the slope of the last piece.
  const double at = natural_logarithm(cell);
  const std::size_t piece = at < edge_[1] ? 0 : 1;
  const double run = edge_[piece + 1] - edge_[piece];
  const double slope = run > 0 ? (occupied_[piece + 1] - occupied_[piece]) / run : -2;
  const double logarithm = occupied_[piece] + slope * (at - edge_[piece]);
  return faces_a_cell * exponential(logarithm);
}

double CellCounts::smallest_cell() const {
  return box_.longest_side() / (axis_cells / 2);
}

double CellCounts::cell_for(double faces) const {
  double low = smallest_cell();
  double high = box_.longest_side() * largest_edge;
  if (!(high > low)) return high > 0 ? high : 1;  // a single point
  while (high > low * (1 + 1e-9)) {
    const double middle = std::sqrt(low * high);
    if (!(middle > low && middle < high)) break;
    (expected_faces(middle) > faces ? low : high) = middle;
  }
  return high;
}

}  // namespace winnow
