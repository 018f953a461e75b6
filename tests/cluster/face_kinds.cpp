// Where the kernel says a face lies is where the grid says it does.
#include "base/morton.hpp"
#include "support/kernels.hpp"

#include <limits>

#include <catch2/catch.hpp>

namespace winnow {

using namespace test;

namespace {

bool on_lattice(const Grid& grid, const Point& p) {
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const double cell = grid.cell_of(p[axis], axis);
    if (!(cell >= 0 && cell < axis_cells)) return false;
  }
  return true;
}

PackedCell cell_of(const Grid& grid, const Point& p) {
  return pack_cell(static_cast<std::uint32_t>(grid.cell_of(p[0], 0)),
                   static_cast<std::uint32_t>(grid.cell_of(p[1], 1)),
                   static_cast<std::uint32_t>(grid.cell_of(p[2], 2)));
}

void check_faces(const std::vector<Triangle>& faces, const Grid& grid) {
  const auto sums = kernel_sums(best_corner_kernel(), faces, grid);
  for (std::size_t i = 0; i < faces.size(); ++i) {
    const Triangle& face = faces[i];
    CAPTURE(i, face[0], face[1], face[2]);
    if (!on_lattice(grid, face[0]) || !on_lattice(grid, face[1]) || !on_lattice(grid, face[2])) {
      REQUIRE(sums->kind[i] == outside);
      continue;
    }
    REQUIRE(sums->kind[i] != outside);
    std::array<PackedCell, 3> cell{};
    for (std::size_t corner = 0; corner < 3; ++corner) {
      cell[corner] = static_cast<PackedCell>(sums->cell[corner][i]);
      REQUIRE(cell[corner] == cell_of(grid, face[corner]));
      for (std::size_t axis = 0; axis < 3; ++axis) {
        const double place = static_cast<double>(sums->place[corner][axis][i]) * 0x1p-22;
        REQUIRE(std::abs(place - grid.place(face[corner][axis], axis)) <= 0x1p-23);
      }
    }
    // The same position has the same place: no repeated corner is missed.
    if (face[0] == face[1] || face[1] == face[2] || face[0] == face[2])
      REQUIRE(sums->kind[i] == close_corners);
    if (sums->kind[i] == close_corners) continue;
    REQUIRE((sums->kind[i] == one_cell) == (cell[0] == cell[1] && cell[1] == cell[2]));
  }
}

}  // namespace

TEST_CASE("the kernel and the grid agree on the cell of every corner") {
  Random random(420);
  for (const double cell : {1.0, 0.1, 1.0 / 3, 2.5, 1e-4}) {
    for (const double offset : {0.0, 5e6, -5e6}) {
      const Grid grid = Grid::around({offset, offset + 1, -offset}, cell);
      for (int round = 0; round < 50; ++round) {
        std::vector<Triangle> faces =
            soup(random, kernel_capacity, random.one_of<double>({0.01, 1, 30}));
        for (Triangle& face : faces) {
          // Corners on the walls between cells and a hair beside them.
          for (Point& corner : face) {
            for (std::size_t axis = 0; axis < 3; ++axis) {
              corner[axis] = (axis == 2 ? -offset : offset) + cell * 100 * corner[axis];
              if (random.chance(0.3))
                corner[axis] =
                    grid.origin[axis] + cell * std::round(grid.place(corner[axis], axis));
              if (random.chance(0.2))
                corner[axis] = std::nextafter(corner[axis], random.one_of<double>({-1e300, 1e300}));
            }
          }
          if (random.chance(0.1)) face[1] = face[0];
        }
        check_faces(faces, grid);
      }
    }
  }
}

TEST_CASE("what lies outside of the lattice is told, by however little") {
  Random random(421);
  const Grid grid = unit_grid();
  constexpr double last = axis_cells;
  std::vector<Triangle> faces;
  for (const double x : {0.0,
                         -0.0,
                         -1e-9,
                         -0x1p-24,
                         -0x1p-23,
                         -0x1p-22,
                         -1.0,
                         last - 1,
                         last - 0x1p-22,
                         last - 0x1p-23,
                         last - 0x1p-24,
                         last,
                         last + 1,
                         0x1p30,
                         -0x1p30,
                         0x1p51,
                         -0x1p51,
                         0x1p52,
                         0x1p53,
                         1e18,
                         -1e18,
                         1e300,
                         -1e300,
                         std::numeric_limits<double>::infinity(),
                         -std::numeric_limits<double>::infinity(),
                         std::numeric_limits<double>::quiet_NaN()}) {
    for (std::size_t corner = 0; corner < 3; ++corner) {
      Triangle face{Point{10, 10, 10}, Point{11, 13, 10}, Point{14, 10, 17}};
      face[corner][random.below(3)] = x;
      faces.push_back(face);
    }
  }
  check_faces(faces, grid);
}

}  // namespace winnow
