// The faces around a vertex are a fan, closed or open, or none.
#include "decimate/fan.hpp"

#include <vector>

#include <catch2/catch.hpp>

namespace winnow {

namespace {

using Rim = std::vector<std::pair<VertexNumber, VertexNumber>>;

// Vertex 0 with these edges across from it.
TileMesh around(const Rim& rim) {
  std::vector<FaceVertices> faces;
  for (const auto& [a, b] : rim) {
    // Any corner first.
    faces.push_back(faces.size() % 3 == 0   ? FaceVertices{0, a, b}
                    : faces.size() % 3 == 1 ? FaceVertices{a, b, 0}
                                            : FaceVertices{b, 0, a});
  }
  std::vector<Point> positions(most_faces_beside_hubs + 3);
  for (std::size_t i = 0; i < positions.size(); ++i) positions[i] = {static_cast<double>(i), 1, 0};
  return {positions, faces, std::vector<std::uint8_t>(positions.size(), 0)};
}

bool found(const TileMesh& mesh, VertexNumber v) {
  return Fan(0).find(mesh, v);
}

}  // namespace

TEST_CASE("a fan that goes all the way round") {
  Fan fan(0);
  REQUIRE(fan.find(around({{1, 2}, {3, 4}, {4, 1}, {2, 3}}), 0));
  CHECK(fan.view().closed);
  CHECK(fan.view().faces() == 4);
  CHECK(fan.view().ends(3) == std::array<std::size_t, 2>{3, 0});
  CHECK(std::vector<VertexNumber>(fan.neighbours().begin(), fan.neighbours().end()) ==
        std::vector<VertexNumber>{1, 2, 3, 4});
  CHECK(fan.view().seen[2] == Point{3, 0, 0});
}

TEST_CASE("an open fan goes from boundary to boundary, however its faces turn") {
  Fan fan(0);
  REQUIRE(fan.find(around({{2, 3}, {2, 1}, {4, 3}}), 0));
  CHECK_FALSE(fan.view().closed);
  CHECK(fan.view().faces() == 3);
  CHECK(std::vector<VertexNumber>(fan.neighbours().begin(), fan.neighbours().end()) ==
        std::vector<VertexNumber>{4, 3, 2, 1});
}

TEST_CASE("two fans, three faces at an edge, a face twice or none at all are no fan") {
  CHECK_FALSE(found(around({{1, 2}, {3, 4}}), 0));
  CHECK_FALSE(found(around({{1, 2}, {2, 3}, {3, 1}, {4, 5}, {5, 6}, {6, 4}}), 0));
  CHECK_FALSE(found(around({{1, 2}, {2, 3}, {2, 4}}), 0));
  CHECK_FALSE(found(around({{1, 2}, {2, 3}, {3, 1}, {1, 4}}), 0));
  CHECK_FALSE(found(around({{1, 2}, {1, 2}}), 0));
  CHECK_FALSE(found(around({{1, 2}}), 5));
}

TEST_CASE("a hub is not removed") {
  Rim rim;
  for (VertexNumber i = 1; i <= most_faces_beside_hubs; ++i) rim.emplace_back(i, i + 1);
  CHECK(found(around(rim), 0));
  rim.emplace_back(most_faces_beside_hubs + 1, most_faces_beside_hubs + 2);
  CHECK_FALSE(found(around(rim), 0));
}

TEST_CASE("a locked vertex is not removed") {
  TileMesh mesh = around({{1, 2}, {2, 3}, {3, 1}});
  CHECK(found(mesh, 0));
  mesh.lock(0);
  CHECK_FALSE(found(mesh, 0));
}

TEST_CASE("what rounding leaves unknown grows with the coordinates, each axis by itself") {
  const TileMesh mesh({{1, 0, -3}, {-1000, 2, 0}, {0, 2, 1}}, {{0, 1, 2}}, {0, 0, 0});
  Fan fan(0.5);
  REQUIRE(fan.find(mesh, 0));
  CHECK(fan.view().off == Point{1000, 2, 3});
}

}  // namespace winnow
