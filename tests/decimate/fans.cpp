// The faces round a vertex are a fan, closed or open, or none.
#include "decimate/fan.hpp"

#include <vector>

#include <catch2/catch.hpp>

namespace winnow {

namespace {

// Vertex 0 with these edges across from it.
TileMesh around(const std::vector<std::pair<VertexNumber, VertexNumber>>& rim) {
  std::vector<FaceVertices> faces;
  for (const auto& [a, b] : rim) {
    // Any corner first.
    faces.push_back(faces.size() % 3 == 0   ? FaceVertices{0, a, b}
                    : faces.size() % 3 == 1 ? FaceVertices{a, b, 0}
                                            : FaceVertices{b, 0, a});
  }
  std::vector<Point> positions(most_faces_of_fan + 3);
  for (std::size_t i = 0; i < positions.size(); ++i) positions[i] = {static_cast<double>(i), 1, 0};
  return {positions, faces, std::vector<std::uint8_t>(positions.size(), 0)};
}

}  // namespace

TEST_CASE("a fan that goes all the way round") {
  Fan fan;
  REQUIRE(fan.find(around({{1, 2}, {3, 4}, {4, 1}, {2, 3}}), 0));
  CHECK(fan.closed());
  CHECK(std::vector<VertexNumber>(fan.neighbours().begin(), fan.neighbours().end()) ==
        std::vector<VertexNumber>{1, 2, 3, 4});
  CHECK(fan.seen()[2] == Point{3, 0, 0});
}

TEST_CASE("an open fan goes from border to border, however its faces turn") {
  Fan fan;
  REQUIRE(fan.find(around({{2, 3}, {2, 1}, {4, 3}}), 0));
  CHECK_FALSE(fan.closed());
  CHECK(std::vector<VertexNumber>(fan.neighbours().begin(), fan.neighbours().end()) ==
        std::vector<VertexNumber>{4, 3, 2, 1});
}

TEST_CASE("two fans, three faces at an edge, a face twice or none at all are no fan") {
  Fan fan;
  CHECK_FALSE(fan.find(around({{1, 2}, {3, 4}}), 0));
  CHECK_FALSE(fan.find(around({{1, 2}, {2, 3}, {3, 1}, {4, 5}, {5, 6}, {6, 4}}), 0));
  CHECK_FALSE(fan.find(around({{1, 2}, {2, 3}, {2, 4}}), 0));
  CHECK_FALSE(fan.find(around({{1, 2}, {2, 3}, {3, 1}, {1, 4}}), 0));
  CHECK_FALSE(fan.find(around({{1, 2}, {1, 2}}), 0));
  CHECK_FALSE(fan.find(around({{1, 2}}), 5));
}

TEST_CASE("a vertex of too many faces waits") {
  std::vector<std::pair<VertexNumber, VertexNumber>> rim;
  for (VertexNumber i = 1; i <= most_faces_of_fan; ++i) rim.emplace_back(i, i + 1);
  Fan fan;
  CHECK(fan.find(around(rim), 0));
  rim.emplace_back(most_faces_of_fan + 1, most_faces_of_fan + 2);
  CHECK_FALSE(fan.find(around(rim), 0));
}

}  // namespace winnow
