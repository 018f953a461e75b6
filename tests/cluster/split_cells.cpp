// Names of the parts of split cells: in the order of keys, and back to cells and places.
#include "cluster/split_cells.hpp"

#include "support/job.hpp"
#include "support/random.hpp"

#include <cmath>
#include <map>
#include <memory>
#include <vector>

#include <catch2/catch.hpp>

namespace winnow::test {

namespace {

PackedCell packed_at(const Grid& grid, const Point& p) {
  std::array<std::uint32_t, 3> cell{};
  for (std::size_t k = 0; k < 3; ++k) cell[k] = static_cast<std::uint32_t>(grid.cell_of(p[k], k));
  return pack_cell(cell[0], cell[1], cell[2]);
}

// The name that the corner at `p` gets.
CellKey name_by_kernel(const SplitCells& split, const Grid& grid, const Point& p) {
  auto corners = std::make_unique<CornerSums>();
  corners->kind[0] = three_cells;
  for (std::size_t c = 0; c < 3; ++c) {
    corners->cell[c][0] = static_cast<std::int64_t>(packed_at(grid, p));
    for (std::size_t k = 0; k < 3; ++k)
      corners->place[c][k][0] =
          static_cast<std::int64_t>(grid.rounded_place(p[k], k) * (1 << fraction_bits));
  }
  split.rename(*corners, 1);
  CHECK(corners->kind[0] == one_cell);
  return morton_key(static_cast<PackedCell>(corners->cell[0][0]));
}

}  // namespace

TEST_CASE("a set of cells has what was put in") {
  TestJob test;
  CellSet set(test.job);
  std::map<PackedCell, unsigned> right;
  Random random(1);
  for (int i = 0; i < 20'000; ++i) {
    const PackedCell cell = pack_cell(static_cast<std::uint32_t>(random.below(40)),
                                      static_cast<std::uint32_t>(random.below(40)),
                                      static_cast<std::uint32_t>(random.below(axis_cells)));
    const auto number = static_cast<unsigned>(1 + random.below(9));
    set.set(cell, number);
    right[cell] = number;
  }
  CHECK(set.size() == right.size());
  for (const auto& [cell, number] : right) CHECK(set.number(cell) == number);
  for (int i = 0; i < 1000; ++i) {
    const PackedCell cell = random.bits() >> 1;
    CHECK(set.number(cell) == (right.contains(cell) ? right[cell] : 0));
  }
}

TEST_CASE("a name says where its part of a cell is") {
  TestJob test;
  Random random(2);
  for (const double cell : {1.0, 0.003, 1e-5}) {
    Box box;
    box.add(Point{-3, 5, 100});
    box.add(Point{-2, 7, 101});
    const Grid grid = Grid::over(box, cell);
    SplitCells split(test.job, grid, box);
    CHECK(split.bits() >= (cell < 1e-4 ? 3 : 10));
    for (int i = 0; i < 500; ++i) {
      const Point p{random.real(-3, -2), random.real(5, 7), random.real(100, 101)};
      const PackedCell at = packed_at(grid, p);
      const CellKey cell_name = split.name_of(morton_key(at));
      const bool whole = split.part_of(cell_name).depth == 0;
      if (whole && random.chance(0.5))
        split.split(at, 1 + static_cast<unsigned>(random.below(split.bits())));
      for (std::uint64_t times = random.below(5); times > 0; --times)
        split.split_further(name_by_kernel(split, grid, p));
      const CellKey name = name_by_kernel(split, grid, p);
      CHECK(split.cell_of(name) == at);
      const SplitCells::Part part = split.part_of(name);
      CHECK(part.size == std::ldexp(1.0, -static_cast<int>(part.depth)));
      for (std::size_t k = 0; k < 3; ++k) {
        const double within = grid.rounded_place(p[k], k) - part.cell[k];
        CHECK(within >= part.low[k]);
        CHECK(within < part.low[k] + part.size);
      }
      if (part.depth == 0) CHECK(name == cell_name);
      CHECK(split.split_further(name) == (part.depth < split.bits()));
      CHECK(split.part_of(name_by_kernel(split, grid, p)).depth >= part.depth);
    }
  }
}

TEST_CASE("names of a cell lie between those of its neighbours") {
  TestJob test;
  Box box;
  box.add(Point{0, 0, 0});
  box.add(Point{8, 8, 8});
  const Grid grid = Grid::over(box, 1);
  SplitCells split(test.job, grid, box);
  Random random(3);
  std::map<CellKey, CellKey> coarse_of;
  std::vector<Point> places;
  for (int i = 0; i < 2000; ++i) {
    const Point p{random.real(0, 8), random.real(0, 8), random.real(0, 8)};
    places.push_back(p);
    if (random.chance(0.3)) split.split_further(name_by_kernel(split, grid, p));
  }
  for (const Point& p : places)
    coarse_of[name_by_kernel(split, grid, p)] = morton_key(packed_at(grid, p));
  CellKey last = 0;
  for (const auto& [name, cell] : coarse_of) {
    CHECK(cell >= last);
    last = cell;
  }
}

}  // namespace winnow::test
