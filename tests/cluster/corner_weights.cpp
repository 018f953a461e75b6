// The weight of a corner is its mixed Voronoi area; the three of a face add up to its area.
#include "support/kernels.hpp"

#include <algorithm>
#include <numbers>

#include <catch2/catch.hpp>

namespace winnow {

using namespace test;

namespace {

constexpr double units = 1 << area_bits;  // in a cell area

// In any plane, around a point inside of the lattice.
Triangle in_space(Random& random, const std::array<std::array<double, 2>, 3>& flat) {
  const Point middle{random.real(500, 1500), random.real(500, 1500), random.real(500, 1500)};
  Point u{random.real(-1, 1), random.real(-1, 1), random.real(-1, 1)};
  u = (1 / length(u)) * u;
  Point w{random.real(-1, 1), random.real(-1, 1), random.real(-1, 1)};
  Point v = cross(u, w);
  v = (1 / length(v)) * v;
  Triangle face{};
  for (std::size_t i = 0; i < 3; ++i) face[i] = middle + flat[i][0] * u + flat[i][1] * v;
  return face;
}

// With these angles at its first two corners, and this edge between them.
Triangle with_angles(Random& random, double first, double second, double edge) {
  const double third = std::numbers::pi - first - second;
  const double side = edge * std::sin(second) / std::sin(third);
  return in_space(random, {{{0, 0}, {edge, 0}, {side * std::cos(first), side * std::sin(first)}}});
}

double angle_at(const Triangle& face, std::size_t corner) {
  const Point u = face[(corner + 1) % 3] - face[corner];
  const Point v = face[(corner + 2) % 3] - face[corner];
  return std::atan2(length(cross(u, v)), dot(u, v));
}

// By the definition (Meyer et al. 2003), with trigonometry instead of products.
std::array<double, 3> voronoi_areas(const Triangle& face) {
  const double area = length(area_vector(face));
  std::array<double, 3> out{};
  const std::array<double, 3> angle{angle_at(face, 0), angle_at(face, 1), angle_at(face, 2)};
  const bool obtuse = *std::max_element(angle.begin(), angle.end()) > std::numbers::pi / 2;
  for (std::size_t a = 0; a < 3; ++a) {
    const std::size_t b = (a + 1) % 3;
    const std::size_t c = (a + 2) % 3;
    const Point ab = face[b] - face[a];
    const Point ac = face[c] - face[a];
    out[a] = (dot(ab, ab) / std::tan(angle[c]) + dot(ac, ac) / std::tan(angle[b])) / 8;
    if (obtuse) out[a] = angle[a] > std::numbers::pi / 2 ? area / 2 : area / 4;
  }
  return out;
}

std::unique_ptr<CornerSums> sums_of(const std::vector<Triangle>& faces) {
  return kernel_sums(best_corner_kernel(), faces, unit_grid());
}

// The corners as the lattice holds them.
Triangle on_lattice(const CornerSums& sums, std::size_t i) {
  Triangle face{};
  for (std::size_t corner = 0; corner < 3; ++corner) {
    for (std::size_t axis = 0; axis < 3; ++axis)
      face[corner][axis] = static_cast<double>(sums.place[corner][axis][i]) * 0x1p-22;
  }
  return face;
}

double weight_sum(const CornerSums& sums, std::size_t i) {
  return static_cast<double>(sums.weight[0][i]) + sums.weight[1][i] + sums.weight[2][i];
}

constexpr double degree = std::numbers::pi / 180;

}  // namespace

TEST_CASE("weights are mixed Voronoi areas, rounded up") {
  Random random(410);
  for (int round = 0; round < 100; ++round) {
    std::vector<Triangle> faces(kernel_capacity);
    for (Triangle& face : faces) {
      const double first = random.real(10, 150) * degree;
      const double second = random.real(5 * degree, std::numbers::pi - first - 5 * degree);
      face = with_angles(random, first, second, std::pow(10, random.real(-1.5, 0.3)));
    }
    const auto sums = sums_of(faces);
    for (std::size_t i = 0; i < faces.size(); ++i) {
      const Triangle face = on_lattice(*sums, i);
      const std::array<double, 3> right = voronoi_areas(face);
      // Next to a right angle the formula's two sides meet, but each by its own rounding.
      for (std::size_t corner = 0; corner < 3; ++corner) {
        CAPTURE(round, i, corner, right[corner] * units, sums->weight[corner][i],
                angle_at(face, 0) / degree, angle_at(face, 1) / degree);
        REQUIRE(std::abs(sums->weight[corner][i] - right[corner] * units) <=
                1 + 1e-4 * length(area_vector(face)) * units);
        REQUIRE(sums->weight[corner][i] >= 1);
      }
    }
  }
}

TEST_CASE("the weights of a face add up to its area") {
  Random random(411);
  for (int round = 0; round < 100; ++round) {
    std::vector<Triangle> faces(kernel_capacity);
    for (Triangle& face : faces) {
      const double first = random.real(1, 178) * degree;
      const double second = random.real(0.3 * degree, std::numbers::pi - first - 0.3 * degree);
      face = with_angles(random, first, second, std::pow(10, random.real(-4, 0.2)));
    }
    const auto sums = sums_of(faces);
    for (std::size_t i = 0; i < faces.size(); ++i) {
      if (sums->kind[i] == close_corners) continue;
      const double area = length(area_vector(on_lattice(*sums, i))) * units;
      if (area > units * 10) continue;  // limited
      CAPTURE(round, i, area, weight_sum(*sums, i));
      REQUIRE(weight_sum(*sums, i) >= area * (1 - 1e-3));
      REQUIRE(weight_sum(*sums, i) <= area * (1 + 1e-3) + 3);
    }
  }
}

TEST_CASE("at an obtuse corner lies half of the area, at the others a quarter each") {
  Random random(412);
  for (std::size_t at = 0; at < 3; ++at) {
    std::vector<Triangle> faces;
    for (int i = 0; i < 100; ++i) {
      const double angle = random.real(91, 175) * degree;
      const Triangle face =
          with_angles(random, angle, random.real(1, 4) * degree, random.real(0.5, 1.5));
      faces.push_back({face[(3 - at) % 3], face[(4 - at) % 3], face[(5 - at) % 3]});
      REQUIRE(angle_at(faces.back(), at) == Approx(angle));
    }
    const auto sums = sums_of(faces);
    for (std::size_t i = 0; i < faces.size(); ++i) {
      const double area = length(area_vector(on_lattice(*sums, i))) * units;
      for (std::size_t corner = 0; corner < 3; ++corner) {
        CAPTURE(at, i, corner, area);
        CHECK(sums->weight[corner][i] ==
              Approx(area / (corner == at ? 2 : 4)).epsilon(1e-4).margin(1));
      }
    }
  }
}

TEST_CASE("a face that is nearly a line weighs nearly nothing, however long it is") {
  // Needles whose two long edges cancel each other, and caps whose obtuse corner lies on the
  // opposite edge.
  Random random(413);
  for (int round = 0; round < 200; ++round) {
    std::vector<Triangle> faces(kernel_capacity);
    for (Triangle& face : faces) {
      const double long_edge = std::pow(10, random.real(-1, 2.5));
      const double width = std::pow(10, random.real(-6.5, -3));
      face = random.chance(0.7)
                 ? in_space(random, {{{0, -width / 2},
                                      {0, width / 2},
                                      {long_edge, width * random.real(-0.5, 0.5)}}})
                 : in_space(random, {{{0, 0}, {long_edge, 0}, {long_edge * random.unit(), width}}});
      std::rotate(face.begin(), face.begin() + static_cast<std::ptrdiff_t>(random.below(3)),
                  face.end());
    }
    const auto sums = sums_of(faces);
    for (std::size_t i = 0; i < faces.size(); ++i) {
      if (sums->kind[i] == close_corners || sums->kind[i] == outside) continue;
      const Triangle face = on_lattice(*sums, i);
      const double area = length(area_vector(face)) * units;
      const double longest = std::max(
          {length(face[1] - face[0]), length(face[2] - face[1]), length(face[0] - face[2])});
      // Floats know the area to about this.
      const double slack = 4 * 0x1p-23 * longest * longest * units;
      CAPTURE(round, i, area / units, weight_sum(*sums, i) / units, longest);
      REQUIRE(weight_sum(*sums, i) <= 1.5 * area + slack + 3);
    }
  }
}

TEST_CASE("a corner weighs at least one unit and at most the limit") {
  Random random(414);
  const auto tiny = sums_of({{Point{1, 1, 1}, Point{1 + 0x1p-22, 1, 1}, Point{1, 1 + 0x1p-22, 1}},
                             {Point{1, 1, 1}, Point{2, 1, 1}, Point{3, 1, 1}}});
  for (std::size_t i = 0; i < 2; ++i) {
    for (std::size_t corner = 0; corner < 3; ++corner) CHECK(tiny->weight[corner][i] == 1);
  }
  CHECK_FALSE(tiny->clamped);
  for (std::size_t axis = 0; axis < 3; ++axis)
    CHECK(tiny->normal[axis][1] == 0);  // no area, no normal
  const auto huge = sums_of({{Point{1, 1, 1}, Point{1e6, 1, 1}, Point{1, 1e6, 1}},
                             {Point{1, 1, 1}, Point{7, 1, 1}, Point{1, 7, 1}}});
  CHECK(huge->clamped);
  for (std::size_t corner = 0; corner < 3; ++corner)
    CHECK(huge->weight[corner][0] == 1 << weight_limit_bits);
  CHECK(huge->weight[0][1] == 9 * (1 << area_bits));
}

TEST_CASE("a normal is one unit long and stands on its face") {
  Random random(415);
  const double scale = 1 << normal_bits;
  for (int round = 0; round < 100; ++round) {
    std::vector<Triangle> faces = soup(random, kernel_capacity, std::pow(10, random.real(-2, 1)));
    faces = placed(faces, 1, {100, 100, 100});
    const auto sums = sums_of(faces);
    for (std::size_t i = 0; i < faces.size(); ++i) {
      const Point n{sums->normal[0][i] / scale, sums->normal[1][i] / scale,
                    sums->normal[2][i] / scale};
      const Point right = area_vector(on_lattice(*sums, i));
      if (length(right) < 1e-7) continue;
      CAPTURE(round, i);
      REQUIRE(std::abs(length(n) - 1) < 1e-5);
      REQUIRE(length(n - (1 / length(right)) * right) < 1e-2);
      for (std::size_t axis = 0; axis < 3; ++axis)
        REQUIRE(std::abs(sums->normal[axis][i]) <= (1 << normal_bits) + 1);
      // The squares of its parts are those of the quadric, and add up to one.
      REQUIRE(sums->squares[0][i] / scale == Approx(n[0] * n[0]).margin(1e-5));
      REQUIRE(sums->squares[1][i] / scale == Approx(n[0] * n[1]).margin(1e-5));
      REQUIRE(sums->squares[2][i] / scale == Approx(n[0] * n[2]).margin(1e-5));
      REQUIRE(sums->squares[3][i] / scale == Approx(n[1] * n[1]).margin(1e-5));
      REQUIRE(sums->squares[4][i] / scale == Approx(n[1] * n[2]).margin(1e-5));
      for (std::size_t corner = 0; corner < 3; ++corner) {
        double distance = 0;
        for (std::size_t axis = 0; axis < 3; ++axis) {
          const double p = static_cast<double>(sums->place[corner][axis][i]) * 0x1p-22;
          distance += n[axis] * (p - std::floor(p) - 0.5);
        }
        for (std::size_t axis = 0; axis < 3; ++axis)
          REQUIRE(sums->moment[corner][axis][i] / scale == Approx(distance * n[axis]).margin(1e-5));
      }
    }
  }
}

TEST_CASE("the sums of a face in one cell are those of its corners") {
  Random random(416);
  for (int round = 0; round < 100; ++round) {
    const auto sums =
        sums_of(placed(soup(random, kernel_capacity, 0.5), random.real(0.1, 2), {3, 4, 5}));
    for (std::size_t i = 0; i < kernel_capacity; ++i) {
      if (sums->kind[i] != one_cell) continue;
      std::int64_t weight = 0;
      for (std::size_t corner = 0; corner < 3; ++corner) weight += sums->weight[corner][i];
      REQUIRE(sums->total_weight[i] == weight);
      for (std::size_t axis = 0; axis < 3; ++axis) {
        std::int64_t position = 0;
        std::int64_t moment = 0;
        for (std::size_t corner = 0; corner < 3; ++corner) {
          position += std::int64_t{sums->weight[corner][i]} *
                      (sums->place[corner][axis][i] & ((1 << fraction_bits) - 1));
          moment += std::int64_t{sums->weight[corner][i]} * sums->moment[corner][axis][i];
        }
        REQUIRE(sums->total_position[axis][i] == position);
        REQUIRE(sums->total_normal[axis][i] == weight * sums->normal[axis][i]);
        REQUIRE(sums->total_moment[axis][i] == moment);
      }
      for (std::size_t k = 0; k < 5; ++k)
        REQUIRE(sums->total_squares[k][i] == weight * sums->squares[k][i]);
    }
  }
}

}  // namespace winnow
