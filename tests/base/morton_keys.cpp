// Cell keys hold three coordinates and order them along the curve.
#include "base/morton.hpp"
#include "support/random.hpp"

#include <bit>

#include <catch2/catch.hpp>

namespace winnow {

namespace {

using Cell = std::array<std::uint32_t, 3>;

// Bit by bit, as the definition says.
CellKey slow_key(const Cell& cell) {
  CellKey key = 0;
  for (unsigned bit = 0; bit < axis_bits; ++bit) {
    for (unsigned axis = 0; axis < 3; ++axis) {
      key |= (CellKey{cell[axis]} >> bit & 1) << (3 * bit + axis);
    }
  }
  return key;
}

std::vector<Cell> some_cells() {
  test::Random random(1);
  std::vector<Cell> cells;
  const std::vector<std::uint32_t> corners{
      0, 1, 2, axis_cells / 2 - 1, axis_cells / 2, axis_cells - 2, axis_cells - 1};
  for (const std::uint32_t x : corners) {
    for (const std::uint32_t y : corners) {
      for (const std::uint32_t z : corners) cells.push_back({x, y, z});
    }
  }
  for (int i = 0; i < 5000; ++i) {
    Cell cell{};
    for (std::uint32_t& c : cell)
      c = static_cast<std::uint32_t>(random.below(axis_cells) >> random.below(axis_bits));
    cells.push_back(cell);
  }
  for (unsigned bit = 0; bit < axis_bits; ++bit) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      Cell cell{};
      cell[axis] = 1U << bit;
      cells.push_back(cell);
    }
  }
  return cells;
}

}  // namespace

TEST_CASE("a key interleaves the bits of its cell and gives the cell back") {
  for (const Cell& cell : some_cells()) {
    CAPTURE(cell);
    const CellKey key = morton_key(cell[0], cell[1], cell[2]);
    REQUIRE(key == slow_key(cell));
    REQUIRE(morton_cell(key) == cell);
    REQUIRE(key >> 63 == 0);
  }
}

TEST_CASE("a packed cell has the same key") {
  for (const Cell& cell : some_cells()) {
    CAPTURE(cell);
    REQUIRE(morton_key(pack_cell(cell[0], cell[1], cell[2])) ==
            morton_key(cell[0], cell[1], cell[2]));
  }
}

TEST_CASE("keys are ordered by the axis whose coordinates differ in the highest bit") {
  const std::vector<Cell> cells = some_cells();
  test::Random random(2);
  for (int i = 0; i < 20000; ++i) {
    const Cell& a = random.one_of(cells);
    const Cell& b = random.one_of(cells);
    // Of equally high bits z's counts more than y's, and that more than x's.
    std::size_t decides = 2;
    for (std::size_t axis = 2; axis-- > 0;) {
      const std::uint32_t here = a[axis] ^ b[axis];
      const std::uint32_t best = a[decides] ^ b[decides];
      if (std::bit_width(here) > std::bit_width(best)) decides = axis;
    }
    CAPTURE(a, b, decides);
    REQUIRE((morton_key(a[0], a[1], a[2]) < morton_key(b[0], b[1], b[2])) ==
            (a[decides] < b[decides]));
  }
}

TEST_CASE("the cells of an octant have neighbouring keys") {
  // What tiles will rely on: a common prefix is a cube.
  for (std::uint32_t i = 0; i < 512; ++i) {
    const Cell cell = morton_cell(CellKey{0x123456} << 9 | i);
    for (std::size_t axis = 0; axis < 3; ++axis)
      REQUIRE(cell[axis] >> 3 == morton_cell(CellKey{0x123456} << 9)[axis] >> 3);
  }
}

}  // namespace winnow
