// The lattice of cells.
#include "cluster/grid.hpp"
#include "support/job.hpp"
#include "support/random.hpp"

#include <cmath>

#include <catch2/catch.hpp>

namespace winnow {

using namespace test;

namespace {

Box random_box(Random& random) {
  Box box;
  const double offset = random.one_of<double>({0, 0, 5e6, -1e9});
  const double size = std::pow(10, random.real(-3, 4));
  for (int i = 0; i < 2; ++i)
    box.add(
        Point{offset + size * random.unit(), -offset + size * random.unit(), size * random.unit()});
  return box;
}

std::size_t longest_axis(const Box& box) {
  std::size_t longest = 0;
  for (std::size_t axis = 1; axis < 3; ++axis) {
    if (box.high[axis] - box.low[axis] > box.high[longest] - box.low[longest]) longest = axis;
  }
  return longest;
}

}  // namespace

TEST_CASE("a number of cells along the longest side is just that") {
  Random random(510);
  for (int round = 0; round < 3000; ++round) {
    const Box box = random_box(random);
    const std::uint64_t cells = random.one_of<std::uint64_t>(
        {1, 2, 3, 10, 512, random.between(1, axis_cells), axis_cells - 1, axis_cells});
    const Grid grid = Grid::over(box, Grid::edge_for(box, cells));
    const std::size_t axis = longest_axis(box);
    CAPTURE(round, cells, box.low, box.high);
    REQUIRE(grid.cell_of(box.low[axis], axis) == 0);
    REQUIRE(grid.cell_of(box.high[axis], axis) == static_cast<double>(cells - 1));
    REQUIRE(grid.cell * static_cast<double>(cells) == Approx(box.longest_side()).epsilon(1e-6));
    for (std::size_t other = 0; other < 3; ++other)
      REQUIRE(grid.cell_of(box.high[other], other) < static_cast<double>(cells));
  }
}

TEST_CASE("a box that needs too many cells is refused with a cell that works") {
  Random random(511);
  for (int round = 0; round < 300; ++round) {
    const Box box = random_box(random);
    const double cell = box.longest_side() / axis_cells / random.real(1.01, 100);
    const Error error = error_of([&] { Grid::over(box, cell); });
    CHECK(error.kind() == ErrorKind::usage);
    const std::string message = error.what();
    const std::size_t at = message.rfind(' ');
    CAPTURE(message);
    CHECK_NOTHROW(Grid::over(box, std::stod(message.substr(at))));
    CHECK(std::stod(message.substr(at)) < box.longest_side() / axis_cells * 1.01);
  }
}

TEST_CASE(
    "without a box the first position is in the middle, and the lattice is the same for any "
    "other") {
  Random random(512);
  for (int round = 0; round < 1000; ++round) {
    const double cell = std::pow(10, random.real(-3, 2));
    const double offset = random.one_of<double>({0, 5e6, -5e6});
    const std::array<double, 3> first{offset + random.real(-50, 50) * cell,
                                      random.real(-50, 50) * cell,
                                      -offset + random.real(-50, 50) * cell};
    const Grid grid = Grid::around(first, cell);
    CAPTURE(round, cell, first);
    for (std::size_t axis = 0; axis < 3; ++axis) {
      // A position a hair below a wall may be rounded onto it.
      const double place = grid.place(first[axis], axis);
      REQUIRE(std::abs(std::floor(place) - axis_cells / 2) <= 1);
      REQUIRE(std::abs(grid.origin[axis] / cell - std::round(grid.origin[axis] / cell)) < 1e-6);
    }
  }
}

TEST_CASE("cells of no sensible size are refused") {
  for (const double cell : {1e-320, 5e-324, HUGE_VAL})
    CHECK(error_of([&] { Grid::around({0, 0, 0}, cell); }).kind() == ErrorKind::usage);
  CHECK(error_of([&] { Grid::around({5e6, 0, 0}, 1e-10); }).kind() == ErrorKind::usage);
  CHECK_NOTHROW(Grid::around({5e6, 0, 0}, 1e-6));
}

TEST_CASE("a box of one point, or none") {
  Box box;
  CHECK(box.empty);
  box.add(Box{});
  CHECK(box.empty);
  box.add(Point{5, 6, 7});
  CHECK_FALSE(box.empty);
  CHECK(box.longest_side() == 0);
  CHECK(Grid::edge_for(box, 100) == 1);
  CHECK_NOTHROW(Grid::over(box, Grid::edge_for(box, 100)));
  box.add(Point{5, 9, 3});
  CHECK(box.longest_side() == 4);
  CHECK(box.diagonal() == 5);
}

}  // namespace winnow
