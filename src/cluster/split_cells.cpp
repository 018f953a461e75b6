#include "cluster/split_cells.hpp"

#include <bit>

namespace winnow {

SplitCells::SplitCells(Job& job, const Grid& grid, const Box& box) : grid_(grid), first_(job) {
  double last = 0;
  for (std::size_t axis = 0; axis < 3; ++axis)
    last = std::max(last, grid.cell_of(box.high[axis], axis));
  const auto used = static_cast<unsigned>(std::bit_width(static_cast<std::uint32_t>(last)));
  bits_ = std::min(axis_bits - used, depths.back());
  for (std::size_t step = 0; step < depths.size(); ++step) further_.emplace_back(job);
}

unsigned SplitCells::step_at(const std::array<std::uint32_t, 3>& place) const {
  unsigned step = first_.number(pack_cell(place[0] >> bits_, place[1] >> bits_, place[2] >> bits_));
  if (step == 0) return 0;
  while (depth_of(step) < bits_ && further_[step - 1].has(part_at(place, depth_of(step)))) ++step;
  return step;
}

void SplitCells::split(PackedCell cell, unsigned depth) {
  unsigned step = 1;
  while (depth_of(step) < std::min(depth, bits_)) ++step;
  first_.set(cell, step);
}

bool SplitCells::split_further(CellKey name) {
  const std::array<std::uint32_t, 3> place = morton_cell(name);
  const unsigned step = step_at(place);
  if (depth_of(step) == bits_) return false;
  if (step == 0) {
    split(cell_of(name), 1);
  } else {
    further_[step - 1].set(part_at(place, depth_of(step)));
  }
  return true;
}

CellKey SplitCells::name_at(const Grid& grid, const Point& position) const {
  std::array<std::uint32_t, 3> place{};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    place[axis] = static_cast<std::uint32_t>(grid.rounded_place(position[axis], axis) *
                                             static_cast<double>(1U << bits_));
  }
  return morton_key(part_at(place, depth_of(step_at(place))));
}

PackedCell SplitCells::cell_of(CellKey name) const {
  const std::array<std::uint32_t, 3> cell = morton_cell(name >> (3 * bits_));
  return pack_cell(cell[0], cell[1], cell[2]);
}

SplitCells::Part SplitCells::part_of(CellKey name) const {
  Part part;
  part.cell = morton_cell(name >> (3 * bits_));
  const std::array<std::uint32_t, 3> place = morton_cell(name);
  part.depth = depth_of(step_at(place));
  part.size = 1.0 / (1U << part.depth);
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const std::uint32_t within = place[axis] & ((1U << bits_) - 1);
    part.low[axis] = static_cast<double>(within) / (1U << bits_);
  }
  return part;
}

std::optional<CellKey> SplitCells::finest_part(const Point& position) const {
  std::array<std::uint32_t, 3> place{};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    place[axis] = static_cast<std::uint32_t>(grid_.rounded_place(position[axis], axis) *
                                             static_cast<double>(1U << bits_));
  }
  if (depth_of(step_at(place)) != bits_) return std::nullopt;
  return morton_key(place[0], place[1], place[2]);
}

void SplitCells::rename(CornerSums& corners, std::size_t count) const {
  for (std::size_t i = 0; i < count; ++i) {
    if (corners.kind[i] == outside) continue;
    std::array<std::int64_t, 3> name{};
    for (std::size_t c = 0; c < 3; ++c) {
      std::array<std::uint32_t, 3> place{};
      for (std::size_t axis = 0; axis < 3; ++axis) {
        const auto all = static_cast<std::uint64_t>(corners.place[c][axis][i]);
        place[axis] = static_cast<std::uint32_t>(all >> (fraction_bits - bits_)) & (axis_cells - 1);
      }
      name[c] = static_cast<std::int64_t>(part_at(place, depth_of(step_at(place))));
    }
    for (std::size_t c = 0; c < 3; ++c) corners.cell[c][i] = name[c];
    if (corners.kind[i] == close_corners) continue;
    const bool ab = name[0] == name[1];
    const bool ac = name[0] == name[2];
    const bool bc = name[1] == name[2];
    corners.kind[i] = ab && ac ? one_cell
                      : bc     ? alone_a
                      : ac     ? alone_b
                      : ab     ? alone_c
                               : three_cells;
  }
}

}  // namespace winnow
