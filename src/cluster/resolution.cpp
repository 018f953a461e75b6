#include "cluster/resolution.hpp"

#include "base/hash.hpp"
#include "base/per_slot.hpp"
#include "read/for_each_batch.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>

namespace winnow {

namespace {

using Point = std::array<double, 3>;

constexpr std::size_t crude_points = 1 << 15;
constexpr std::size_t wanted_points = 250'000;
constexpr double points_a_cell = 64;  // enough that a cell the surface only grazes is rarely missed
constexpr double cells_a_block = 16;  // along an edge
// A clustered surface has about two faces a vertex, as any closed triangle mesh.
constexpr double faces_a_cell = 2;

std::uint64_t hash_point(const Point& p) {
  // -0 and 0 are the same place.
  const auto bits = [](double v) { return std::bit_cast<std::uint64_t>(v + 0.0); };
  return mixed_hash(bits(p[0]) * 0x9e3779b97f4a7c15 ^ std::rotl(bits(p[1]) * 0xbf58476d1ce4e5b9, 21) ^
                    std::rotl(bits(p[2]) * 0x94d049bb133111eb, 42));
}

bool finite(const Point& p) {
  // Infinities and what is no number differ from themselves less themselves.
  return p[0] - p[0] == 0 && p[1] - p[1] == 0 && p[2] - p[2] == 0;
}

Point point_at(const PositionView& view, std::size_t i) { return {view.axis[0][i], view.axis[1][i], view.axis[2][i]}; }

void add_to_box(const PositionView& view, Box& box) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  Box part{{infinity, infinity, infinity}, {-infinity, -infinity, -infinity}, view.count == 0};
  double wrong = 0;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const double* p = view.axis[axis];
    double low = infinity;
    double high = -infinity;
    for (std::size_t i = 0; i < view.count; ++i) {
      wrong += p[i] - p[i];
      low = p[i] < low ? p[i] : low;
      high = p[i] > high ? p[i] : high;
    }
    part.low[axis] = low;
    part.high[axis] = high;
  }
  if (wrong == 0) return box.add(part);
  // Something is not finite: one position at a time.
  for (std::size_t i = 0; i < view.count; ++i) {
    if (finite(point_at(view, i))) box.add(point_at(view, i));
  }
}

// Points whose hash is below a bound that falls until few enough are left. The rest depends on the set of
// points alone.
struct ThinnedPoints {
  std::uint64_t bound = UINT64_MAX;
  std::vector<Point> points;

  void add(const Point& point, std::uint64_t hash) {
    if (hash > bound) return;
    points.push_back(point);
    if (points.size() > 2 * crude_points) thin(bound / 2);
  }

  void thin(std::uint64_t to) {
    bound = to;
    std::erase_if(points, [&](const Point& p) { return hash_point(p) > bound; });
  }

  void merge(ThinnedPoints& other) {
    const std::uint64_t lower = std::min(bound, other.bound);
    thin(lower);
    other.thin(lower);
    points.insert(points.end(), other.points.begin(), other.points.end());
    while (points.size() > 2 * crude_points) thin(bound / 2);
  }
};

// How many different cells the points fall into, of those that `counts` says to count.
template <typename Counts>
std::size_t distinct_cells(const std::vector<Point>& points, const Grid& grid, Counts counts) {
  // A table of hashes: two cells that share all 64 bits are not to be expected among 2^18.
  std::vector<std::uint64_t> table(std::bit_ceil(2 * points.size() + 2));
  std::size_t found = 0;
  for (const Point& point : points) {
    std::array<std::uint32_t, 3> cell{};
    for (std::size_t axis = 0; axis < 3; ++axis) cell[axis] = static_cast<std::uint32_t>(grid.place(point[axis], axis));
    const std::uint64_t key = mixed_hash(pack_cell(cell[0], cell[1], cell[2])) | 1;
    std::size_t at = key >> 32 & (table.size() - 1);
    while (table[at] != 0 && table[at] != key) at = (at + 1) & (table.size() - 1);
    if (table[at] == key) continue;
    table[at] = key;
    found += counts(cell) ? 1 : 0;
  }
  return found;
}

}  // namespace

Box measure_box(Job& job, MeshReader& reader) {
  job.progress.begin("measure", reader.facts().vertices.value_or(3 * reader.facts().faces.value_or(0)), "positions");
  PerSlot<Box> boxes(job.threads, [] { return std::make_unique<Box>(); });
  for_each_position_batch(job, reader, [&](const PositionView& view) { add_to_box(view, boxes.local()); });
  Box box;
  for (const Box* part : boxes.all()) box.add(*part);
  return box;
}

CellSample::CellSample(Job& job, MeshReader& reader, std::uint64_t wanted_faces) {
  job.progress.begin("sample", reader.facts().vertices.value_or(reader.facts().faces.value_or(0)), "positions");
  struct Crude {
    Box box;
    ThinnedPoints thinned;
    std::uint64_t positions = 0;
  };
  PerSlot<Crude> slots(job.threads, [] { return std::make_unique<Crude>(); });
  for_each_position_batch(job, reader, [&](const PositionView& view) {
    Crude& crude = slots.local();
    add_to_box(view, crude.box);
    for (std::size_t i = 0; i < view.count; ++i) {
      const Point point = point_at(view, i);
      if (!finite(point)) continue;
      ++crude.positions;
      crude.thinned.add(point, hash_point(point));
    }
  });
  ThinnedPoints thinned;
  for (Crude* crude : slots.all()) {
    box_.add(crude->box);
    positions_ += crude->positions;
    thinned.merge(crude->thinned);
  }
  slots.clear();
  if (box_.empty || !(box_.longest_side() > 0)) return;

  const double cells = std::max(1.0, static_cast<double>(wanted_faces) / faces_a_cell);
  block_ = cells_a_block * crude_cell(thinned.points, cells);
  // Thin the points to what a cell needs, and take as many blocks as fill the sample.
  const double a_cell = std::max(1.0, static_cast<double>(positions_) / cells / points_a_cell);
  const double blocks = std::max(1.0, static_cast<double>(positions_) / a_cell / wanted_points);
  const auto bound = [](double one_in) { return one_in <= 1 ? UINT64_MAX : static_cast<std::uint64_t>(0x1p64 / one_in); };
  point_bound_ = bound(a_cell);
  block_bound_ = bound(blocks);
  if (blocks <= 1) block_ = box_.longest_side() * 2;
  sample_blocks(job, reader);
}

// From points picked blindly: good while cells hold many of them; smaller cells are extrapolated, as on a
// surface four times as many are half as wide.
double CellSample::crude_cell(const std::vector<Point>& points, double cells) const {
  const double trusted = static_cast<double>(points.size()) / 24;
  const double wanted = std::min(cells, std::max(1.0, trusted));
  double low = box_.longest_side() / (axis_cells / 2);
  double high = box_.longest_side() * 1.001;
  for (int step = 0; step < 40 && high > low * 1.02; ++step) {
    const double middle = std::sqrt(low * high);
    const auto found = static_cast<double>(distinct_cells(points, Grid::over(box_, middle), [](const auto&) { return true; }));
    (found > wanted ? low : high) = middle;
  }
  return high * std::sqrt(wanted / cells);
}

namespace {
std::uint64_t block_hash(const Point& point, const Point& low, double block) {
  std::array<std::uint32_t, 3> at{};
  for (std::size_t axis = 0; axis < 3; ++axis) at[axis] = static_cast<std::uint32_t>((point[axis] - low[axis]) / block);
  return mixed_hash(pack_cell(at[0], at[1], at[2]));
}
}  // namespace

void CellSample::sample_blocks(Job& job, MeshReader& reader) {
  struct Part {
    std::vector<Point> points;
    std::uint64_t in_blocks = 0;
  };
  PerSlot<Part> slots(job.threads, [] { return std::make_unique<Part>(); });
  for_each_position_batch(job, reader, [&](const PositionView& view) {
    Part& part = slots.local();
    for (std::size_t i = 0; i < view.count; ++i) {
      const Point point = point_at(view, i);
      if (!finite(point) || block_hash(point, box_.low, block_) > block_bound_) continue;
      ++part.in_blocks;
      if (hash_point(point) <= point_bound_) part.points.push_back(point);
    }
  });
  std::uint64_t in_blocks = 0;
  for (Part* part : slots.all()) {
    points_.insert(points_.end(), part->points.begin(), part->points.end());
    in_blocks += part->in_blocks;
  }
  scale_ = in_blocks == 0 ? 1 : static_cast<double>(positions_) / static_cast<double>(in_blocks);
}

double CellSample::expected_faces(double cell) const {
  if (points_.empty()) return 0;
  const Grid grid = Grid::over(box_, cell);
  // A cell that straddles the border of a block belongs to the block its middle is in.
  const auto counts = [&](const std::array<std::uint32_t, 3>& at) {
    Point middle{};
    for (std::size_t axis = 0; axis < 3; ++axis) middle[axis] = box_.low[axis] + (at[axis] + 0.5) * cell;
    return block_hash(middle, box_.low, block_) <= block_bound_;
  };
  return faces_a_cell * scale_ * static_cast<double>(distinct_cells(points_, grid, counts));
}

double CellSample::cell_for(double faces) const {
  double low = box_.longest_side() / (axis_cells / 2);
  double high = box_.longest_side() * 1.001;
  if (points_.empty() || !(high > low)) return high > 0 ? high : 1;
  // On a surface the count grows with the inverse square of the edge: each guess is close to the last.
  double guess = std::clamp(block_ / cells_a_block, low, high);
  for (int step = 0; step < 60 && high > low * 1.0005; ++step) {
    const double found = expected_faces(guess);
    if (found > faces) {
      low = guess;
    } else {
      high = guess;
    }
    if (std::abs(found - faces) <= 0.002 * faces) return guess;
    const double next = found > 0 ? guess * std::sqrt(found / faces) : guess;
    guess = next > low * 1.0001 && next < high * 0.9999 && step < 8 ? next : std::sqrt(low * high);
  }
  return high;
}

}  // namespace winnow
