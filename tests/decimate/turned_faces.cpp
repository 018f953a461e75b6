// Which faces turn when a vertex goes to a neighbour, and which stay in their planes.
#include "decimate/fan.hpp"

#include <vector>

#include <catch2/catch.hpp>

namespace winnow {

namespace {

std::vector<TurnedFace> turned(const std::vector<Point>& seen, std::size_t into,
                               const Point& off = {}) {
  std::vector<TurnedFace> faces;
  for_each_turned({seen, true, off}, into, [&](const TurnedFace& face) { faces.push_back(face); });
  return faces;
}

}  // namespace

TEST_CASE("of the corner of a cube one face turns, the one across") {
  const auto faces = turned({{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, 0);
  REQUIRE(faces.size() == 1);
  CHECK(faces[0].before == Point{1, 0, 0});
  CHECK(faces[0].after == Point{1, 1, 1});
  CHECK(faces[0].side == Point{0, -1, 1});
  CHECK(faces[0].swept == 1);
}

TEST_CASE("along a straight crease nothing turns, and across it something does") {
  const std::vector<Point> crease{{1, 0, 0}, {0, 1, -1}, {-1, 0, 0}, {0, -1, -1}};
  CHECK(turned(crease, 0).empty());
  CHECK(turned(crease, 2).empty());
  CHECK(turned(crease, 1).size() == 2);
}

TEST_CASE("a face stays in its plane where rounding may have put the neighbour off it") {
  const std::vector<Point> bent{{1, 0, 0}, {0, 1, -1}, {-1, 0, 0.001}, {0, -1, -1}};
  CHECK(turned(bent, 0, {0, 0, 0.0001}).size() == 2);
  CHECK(turned(bent, 0, {0.001, 0.001, 0.001}).empty());
}

TEST_CASE("a face thinner than rounding does not turn") {
  // The first face is a line, but for rounding; the neighbour is far from it.
  const std::vector<Point> thin{{1, 0, 0}, {-1, 1e-7, 0}, {0, -1, 0.5}};
  CHECK(turned(thin, 2).size() == 1);
  CHECK(turned(thin, 2, {1e-7, 1e-7, 1e-7}).empty());
}

}  // namespace winnow
