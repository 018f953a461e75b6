// A vertex goes into the nearer end of the line that passes closest to it; refused, into the next.
#include "decimate/nearest_lines.hpp"
#include "decimate/volume_cost.hpp"

#include <vector>

#include <catch2/catch.hpp>

namespace winnow {

namespace {

// A ridge from the first neighbour to the third, the first nearer.
const std::vector<Point> ridge{{1, 0, -0.1}, {0, 1, -1}, {-2, 0, -0.2}, {0, -1, -1}};

// An apex over that ring, closed by a vertex far below.
TileMesh pyramid() {
  std::vector<Point> positions = ridge;
  positions.push_back({0, 0, 0});
  positions.push_back({0, 0, -9});
  std::vector<FaceVertices> faces;
  for (VertexNumber i = 0; i < 4; ++i) {
    faces.push_back({4, i, (i + 1) % 4});
    faces.push_back({5, (i + 1) % 4, i});
  }
  return {positions, faces, std::vector<std::uint8_t>(6, 0)};
}

}  // namespace

TEST_CASE("the line along the ridge is the first, and its near end") {
  // The far end of the ridge is the nearer end of no line.
  CHECK(nearest_line_ends(ridge) == std::vector<std::size_t>{0, 1, 3});
}

TEST_CASE("of lines as close the near ends go first") {
  const std::vector<Point> flat{{2, 0, 0}, {0, 1, 0}, {-2, 0, 0}, {0, -1.5, 0}};
  CHECK(nearest_line_ends(flat) == std::vector<std::size_t>{1, 0, 3});
}

TEST_CASE("neighbours in the same place have no line between them") {
  CHECK(nearest_line_ends(std::vector<Point>{{1, 0, 0}, {1, 0, 0}}).empty());
}

TEST_CASE("a vertex that is refused proposes the next, at the same price, until there is none") {
  TileMesh mesh = pyramid();
  VolumeCost cost(mesh);
  const Candidate first = cost.best(4, Candidate::none_yet());
  REQUIRE(first.exists());
  CHECK(first.partner == 0);
  const Candidate second = cost.best(4, first);
  CHECK(second.partner == 1);
  CHECK(second.price == first.price);
  const Candidate third = cost.best(4, second);
  CHECK(third.partner == 3);
  CHECK_FALSE(cost.best(4, third).exists());
}

}  // namespace winnow
