// The corner kernels of every instruction set give the same bits.
#include "support/kernels.hpp"
#include "support/not_finite.hpp"

#include <limits>

#include <catch2/catch.hpp>

namespace winnow {

using namespace test;

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr double lattice = axis_cells;

Point somewhere(Random& random, double size) {
  const Point middle{random.real(0, lattice), random.real(0, lattice), random.real(0, lattice)};
  Point p{};
  for (std::size_t axis = 0; axis < 3; ++axis)
    p[axis] = std::clamp(middle[axis] + size * random.real(-1, 1), 0.0, lattice - 1);
  return p;
}

Triangle near(Random& random, double size) {
  const Point middle = somewhere(random, 0);
  Triangle face{};
  for (Point& corner : face) {
    for (std::size_t axis = 0; axis < 3; ++axis)
      corner[axis] = std::abs(middle[axis] + size * random.real(-1, 1));
  }
  return face;
}

// Everything that arithmetic may stumble over.
Triangle nasty(Random& random) {
  Triangle face = near(random, std::pow(10, random.real(-9, 6)));
  const std::size_t corner = random.below(3);
  const std::size_t other = (corner + 1) % 3;
  const std::size_t axis = random.below(3);
  switch (random.below(16)) {
    case 0:
      face[corner] = face[other];
      break;  // repeated
    case 1:
      face[corner] = 0.5 * (face[other] + face[(corner + 2) % 3]);
      break;  // no area
    case 2:
      face[corner] = face[other] + Point{1e-7, 0, 0};
      break;  // a needle
    case 3:
      face[corner] = 0.5 * (face[other] + face[(corner + 2) % 3]) + Point{0, 0, 1e-6};
      break;  // flat and obtuse
    case 4:
      face[corner][axis] = random.one_of<double>({nan, infinity, -infinity, -nan, 1e300, -1e300});
      break;
    case 5:
      face[corner][axis] = random.one_of<double>(
          {-1e-9, -1, lattice, lattice - 1e-9, lattice + 5, -0x1p51, 0x1p51, 0x1p52, 1e18});
      break;
    case 6:  // on the walls of cells
      for (Point& p : face) {
        for (double& x : p) x = std::floor(x);
      }
      break;
    case 7:  // half a step beside them
      for (Point& p : face) {
        for (double& x : p)
          x = std::floor(x) + random.one_of<double>({0x1p-23, -0x1p-23, 0x1p-22, 0.5, 1 - 0x1p-23});
      }
      break;
    case 8:
      face = {Point{0, 0, 0}, Point{lattice - 1, 0, 0}, Point{0, lattice - 1, lattice - 1}};
      break;  // all of the lattice
    case 9:
      face[corner] = {0, -0.0, 5e-324};
      break;
    case 10:  // equilateral, and with a right angle
      face = {Point{1, 0, 0}, Point{0, 1, 0}, Point{0, 0, 1}};
      break;
    case 11:
      face = {Point{7, 7, 7}, Point{8, 7, 7}, Point{7, 8, 7}};
      break;
    case 12:
      face[corner] = 10 * face[other] + -9 * face[(corner + 2) % 3];
      break;
    default:
      break;
  }
  return face;
}

template <typename Number, std::size_t N>
bool same(const Number (&a)[N], const Number (&b)[N], std::size_t i) {
  return a[i] == b[i];
}
template <typename Number, std::size_t M, std::size_t N>
bool same(const Number (&a)[M][N], const Number (&b)[M][N], std::size_t i) {
  bool all = true;
  for (std::size_t k = 0; k < M; ++k) all = all && same(a[k], b[k], i);
  return all;
}
template <typename Number, std::size_t L, std::size_t M, std::size_t N>
bool same(const Number (&a)[L][M][N], const Number (&b)[L][M][N], std::size_t i) {
  bool all = true;
  for (std::size_t k = 0; k < L; ++k) all = all && same(a[k], b[k], i);
  return all;
}

std::string difference(const CornerSums& a, const CornerSums& b, std::size_t count) {
  for (std::size_t i = 0; i < count; ++i) {
    const std::string at = " of face " + std::to_string(i);
    if (!same(a.kind, b.kind, i)) return "kind" + at;
    if (a.kind[i] == outside) continue;
    if (!same(a.place, b.place, i)) return "place" + at;
    if (!same(a.cell, b.cell, i)) return "cell" + at;
    if (!same(a.weight, b.weight, i)) return "weight" + at;
    if (!same(a.normal, b.normal, i)) return "normal" + at;
    if (!same(a.squares, b.squares, i)) return "squares" + at;
    if (!same(a.moment, b.moment, i)) return "moment" + at;
    if (!a.far && !same(a.doubled_area, b.doubled_area, i)) return "doubled area" + at;
    if (a.kind[i] != one_cell) continue;
    if (!same(a.doubled_area, b.doubled_area, i)) return "doubled area in a cell" + at;
    if (!same(a.total_weight, b.total_weight, i)) return "total weight" + at;
    if (!same(a.total_position, b.total_position, i)) return "total position" + at;
    if (!same(a.total_normal, b.total_normal, i)) return "total normal" + at;
    if (!same(a.total_squares, b.total_squares, i)) return "total squares" + at;
    if (!same(a.total_moment, b.total_moment, i)) return "total moment" + at;
  }
  if (a.far != b.far) return "far";
  return a.clamped == b.clamped ? "" : "clamped";
}

void check_same(const std::vector<Triangle>& faces, const Grid& grid) {
  for (const bool single : {false, true}) {
    const auto right = kernel_sums(corner_kernel_baseline, faces, grid, single);
    for (const auto& [name, kernel] : runnable_kernels()) {
      CAPTURE(name, single);
      REQUIRE(difference(*kernel_sums(kernel, faces, grid, single), *right, faces.size()) == "");
    }
  }
}

std::vector<Grid> grids(Random& random) {
  std::vector<Grid> all{unit_grid()};
  // Others see the same places through other numbers.
  for (const double cell : {0.1, 1.0 / 3, 7.25, 1e-5, 1e6}) {
    all.push_back({{random.real(-1e6, 1e6) * cell, -5e6, 5e6}, cell, 1 / cell});
  }
  return all;
}

}  // namespace

TEST_CASE("random faces have the same sums by every kernel") {
  Random random(400);
  for (const Grid& grid : grids(random)) {
    for (const double size : {0.01, 0.3, 1.0, 30.0, 1e5}) {
      for (int round = 0; round < 30; ++round) {
        std::vector<Triangle> faces(random.between(1, kernel_capacity));
        for (Triangle& face : faces) face = near(random, size);
        faces = placed(faces, grid.cell, grid.origin);
        check_same(faces, grid);
      }
    }
  }
}

TEST_CASE("nasty faces have the same sums by every kernel") {
  Random random(401);
  for (const Grid& grid : grids(random)) {
    for (int round = 0; round < 150; ++round) {
      std::vector<Triangle> faces(random.between(1, kernel_capacity));
      for (Triangle& face : faces) face = nasty(random);
      check_same(placed(faces, grid.cell, grid.origin), grid);
    }
  }
}

TEST_CASE("the kernel that runs is one of those that are the same") {
  const auto kernels = runnable_kernels();
  CHECK(best_corner_kernel() == kernels.back().second);
}

TEST_CASE("floats give the sums of the doubles that they are") {
  Random random(402);
  for (const Grid& grid : grids(random)) {
    std::vector<Triangle> faces(kernel_capacity);
    for (Triangle& face : faces) face = near(random, 0.5);
    faces = as_floats(placed(faces, grid.cell, grid.origin));
    const auto single = kernel_sums(best_corner_kernel(), faces, grid, true);
    const auto wide = kernel_sums(best_corner_kernel(), faces, grid, false);
    CHECK(difference(*single, *wide, faces.size()) == "");
  }
}

}  // namespace winnow
