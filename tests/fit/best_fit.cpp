// Fits whose result is known by hand.
#include "fit/vertex_fit.hpp"
#include "support/random.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <vector>

#include <catch2/catch.hpp>

namespace winnow::test {

namespace {

// A flat fan of six faces around vertex 0, with the sums of samples of each face.
struct Fan {
  std::vector<Point> positions{{0, 0, 0}};
  std::vector<FaceVertices> faces;
  std::vector<FaceSums> sums{6};
  std::vector<std::uint8_t> locked = std::vector<std::uint8_t>(7, 0);
  double far = 10;
  double ceiling = 10;
  double squares = 0;  // of all samples
  double gain = 0;     // of the last fit
  int asked = 0;       // how often whether a face is farther

  Fan() {
    for (std::uint32_t i = 0; i < 6; ++i) {
      const double angle = i * std::numbers::pi / 3;
      positions.push_back({std::cos(angle), std::sin(angle), 0});
      faces.push_back({0, 1 + i, 1 + (i + 1) % 6});
    }
  }

  void add(std::size_t face, const std::array<double, 3>& weight, const Point& way) {
    FaceSums& sum = sums[face];
    const auto to = [](float& x, double more) { x = static_cast<float>(double{x} + more); };
    for (std::size_t i = 0; i < 3; ++i) {
      to(sum.products[i], weight[i] * weight[i]);
      to(sum.products[3 + i], weight[i] * weight[(i + 1) % 3]);
      for (std::size_t axis = 0; axis < 3; ++axis) to(sum.pull[i][axis], weight[i] * way[axis]);
    }
    sum.farthest = std::max(sum.farthest, static_cast<float>(dot(way, way)));
    squares += dot(way, way);
  }

  // Samples on a cone over the fan, whose apex is over vertex 0.
  void add_cone(double height) {
    Random random(1);
    for (std::size_t f = 0; f < 6; ++f) {
      for (int i = 0; i < 40; ++i) {
        double second = random.unit();
        double third = random.unit();
        if (second + third > 1) {
          second = 1 - second;
          third = 1 - third;
        }
        const double first = 1 - second - third;
        add(f, {first, second, third}, {0, 0, height * first});
      }
    }
  }

  std::vector<std::uint32_t> fit(double degrees = 60) {
    VertexFitSettings settings;
    settings.single = false;
    settings.least_cosine = std::cos(degrees / 180 * std::numbers::pi);
    settings.far = far;
    FittedVertices done = fit_vertices(
        positions, faces, sums, locked, settings,
        [this](std::span<const Triangle>, std::span<const Triangle> after) {
          ++asked;
          std::array<bool, 3> farther{};
          for (std::size_t i = 0; i < 3; ++i) farther[i] = after[0][i][2] > ceiling;
          return farther;
        },
        [] {});
    gain = done.gain;
    return done.moved;
  }
};

}  // namespace

TEST_CASE("a vertex moves onto the apex of a cone but for the pull back") {
  Fan fan;
  fan.add_cone(0.3);
  CHECK(fan.fit() == std::vector<std::uint32_t>{0});
  // The sum of squares (0.3 - x) w, and 2 % of the weights' squares times x.
  CHECK(fan.positions[0][2] == Approx(0.3 / 1.02).epsilon(1e-5));
  // What is left of 0.3 w at each sample is (0.3 - x) w.
  const double left = 1 - 1 / 1.02;
  CHECK(fan.gain == Approx(fan.squares * (1 - left * left)).epsilon(1e-5));
  CHECK(std::abs(fan.positions[0][0]) < 1e-5);
  CHECK(std::abs(fan.positions[0][1]) < 1e-5);
}

TEST_CASE("vertices at a boundary stay whatever their samples say") {
  Fan fan;
  const std::vector<Point> before = fan.positions;
  for (std::size_t f = 0; f < 6; ++f) {
    for (int i = 0; i < 10; ++i) fan.add(f, {0.1, 0.4, 0.5}, {0, 0, 0.1});
  }
  fan.fit();
  for (std::size_t v = 1; v < 7; ++v) CHECK(fan.positions[v] == before[v]);
  CHECK(fan.positions[0] != before[0]);
}

TEST_CASE("a locked vertex stays") {
  Fan fan;
  fan.add_cone(0.3);
  fan.locked[0] = 1;
  CHECK(fan.fit().empty());
  CHECK(fan.positions[0] == Point{});
}

TEST_CASE("a vertex of one face that is met exactly stays") {
  Fan fan;
  fan.add_cone(0.3);
  fan.sums[2] = {};
  for (int i = 0; i < 10; ++i) fan.add(2, {0.2, 0.3, 0.5}, {1e-17, 0, 1e-17});
  CHECK(fan.fit().empty());
}

TEST_CASE("a vertex stays where a face would turn too far") {
  for (const double degrees : {5.0, 60.0}) {
    Fan fan;
    // 0.3 above an edge that is 0.866 away: 19 degrees.
    fan.add_cone(0.3);
    CHECK(fan.fit(degrees).empty() == (degrees == 5));
  }
}

TEST_CASE("a vertex stays where it would come farther from the original") {
  Fan fan;
  fan.add_cone(0.3);
  fan.ceiling = 0.2;
  fan.far = 0.1;
  CHECK(fan.fit().empty());
  // Nobody asks where no face can be far off.
  fan.far = 10;
  CHECK(fan.fit().size() == 1);
}

TEST_CASE("faces are compared with the original where samples leave it open how far off they are") {
  for (const double height : {0, 2}) {
    for (const double far : {0.1, 0.3, 0.5}) {
      Fan fan;
      fan.positions[0][2] = height;
      fan.add_cone(0.1);
      fan.far = far;
      INFO(height << " " << far);
      CHECK(fan.fit().size() == 1);
      // Of 0.1 to 0.25, or three times the farthest sample and the way at the tip.
      CHECK((fan.asked > 0) == (far < (height > 0 ? 0.4 : 0.25)));
    }
  }
  // 0.01 is next to nothing beside 1, although samples are far off.
  Fan fan;
  fan.add_cone(0.01);
  fan.sums[0].farthest = 4;
  fan.far = 1;
  CHECK(fan.fit().size() == 1);
  CHECK(fan.asked == 0);
}

TEST_CASE("no face is folded over") {
  Fan fan;
  // All samples say that the vertex is far outside of its fan.
  for (std::size_t f = 0; f < 6; ++f) {
    for (int i = 0; i < 20; ++i) fan.add(f, {0.6, 0.2, 0.2}, {300, 0, 1});
  }
  const std::vector<Point> before = fan.positions;
  fan.fit();
  for (const auto& [a, b, c] : fan.faces)
    CHECK(doubled_area({fan.positions[a], fan.positions[b], fan.positions[c]})[2] > 0);
}

}  // namespace winnow::test
