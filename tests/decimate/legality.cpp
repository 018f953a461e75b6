// Which edges may be collapsed: cases whose answer is known, and what no collapse of any mesh may
// bring about.
#include "decimate/legality.hpp"

#include "base/rounding.hpp"
#include "support/refining.hpp"
#include "support/tile_meshes.hpp"

#include <algorithm>
#include <map>
#include <numbers>
#include <set>

#include <catch2/catch.hpp>

namespace winnow {

using namespace test;

namespace {

using Edge = std::pair<VertexNumber, VertexNumber>;

TileMesh mesh_of(const std::vector<FaceVertices>& faces, std::vector<Point> positions = {}) {
  VertexNumber vertices = 0;
  for (const FaceVertices& face : faces)
    vertices = std::max({vertices, face[0] + 1, face[1] + 1, face[2] + 1});
  positions.resize(vertices);
  return {positions, faces, std::vector<std::uint8_t>(vertices, 0)};
}

EdgeStar star_of(const TileMesh& mesh, VertexNumber kept, VertexNumber removed) {
  EdgeStar star(rounding_of_double);
  star.find(mesh, kept, removed);
  return star;
}

// From either end it is the same question.
bool may(const std::vector<FaceVertices>& faces, VertexNumber a, VertexNumber b) {
  TileMesh mesh = mesh_of(faces);
  Legality legality(mesh, 0);
  const bool answer = legality.keeps_surface(star_of(mesh, a, b));
  CHECK(legality.keeps_surface(star_of(mesh, b, a)) == answer);
  return answer;
}

std::map<Edge, unsigned> edges_of(const std::vector<FaceVertices>& faces) {
  std::map<Edge, unsigned> edges;
  for (const FaceVertices& face : faces) {
    for (std::size_t i = 0; i < 3; ++i) ++edges[std::minmax(face[i], face[(i + 1) % 3])];
  }
  return edges;
}

int euler_characteristic(const std::vector<FaceVertices>& faces) {
  std::set<VertexNumber> vertices;
  for (const FaceVertices& face : faces) vertices.insert(face.begin(), face.end());
  return static_cast<int>(vertices.size()) - static_cast<int>(edges_of(faces).size()) +
         static_cast<int>(faces.size());
}

}  // namespace

TEST_CASE("edges of a tetrahedron stay") {
  const std::vector<FaceVertices> faces{{0, 1, 2}, {0, 3, 1}, {1, 3, 2}, {2, 3, 0}};
  for (VertexNumber a = 0; a < 4; ++a) {
    for (VertexNumber b = a + 1; b < 4; ++b) CHECK_FALSE(may(faces, a, b));
  }
}

TEST_CASE("two fans over one ring become a tetrahedron but do not fall together") {
  // The poles 0 and 1 over the ring 2 3 4: a ring of three is the link of no edge of its own.
  const std::vector<FaceVertices> three{{0, 2, 3}, {0, 3, 4}, {0, 4, 2},
                                        {1, 3, 2}, {1, 4, 3}, {1, 2, 4}};
  CHECK_FALSE(may(three, 2, 3));
  CHECK(may(three, 0, 2));
  // With four in the ring every edge may go.
  const std::vector<FaceVertices> four{{0, 2, 3}, {0, 3, 4}, {0, 4, 5}, {0, 5, 2},
                                       {1, 3, 2}, {1, 4, 3}, {1, 5, 4}, {1, 2, 5}};
  CHECK(may(four, 2, 3));
  CHECK(may(four, 0, 2));
  // Vertices without a common edge have nothing to collapse.
  CHECK_FALSE(may(four, 0, 1));
}

TEST_CASE("boundaries are not pinched") {
  // A strip: 0 1 2 3 above, 4 5 6 7 below.
  const std::vector<FaceVertices> strip{{0, 4, 5}, {0, 5, 1}, {1, 5, 6},
                                        {1, 6, 2}, {2, 6, 7}, {2, 7, 3}};
  CHECK_FALSE(may(strip, 1, 5));
  CHECK_FALSE(may(strip, 1, 6));
  CHECK(may(strip, 1, 2));
  CHECK(may(strip, 5, 6));
  // A hole of three sides would close.
  const std::vector<FaceVertices> hole{{0, 1, 4}, {0, 4, 3}, {1, 2, 5},
                                       {1, 5, 4}, {2, 0, 3}, {2, 3, 5}};
  CHECK_FALSE(may(hole, 3, 4));
  // From inside to the boundary is free.
  const std::vector<FaceVertices> fan{{0, 1, 2}, {0, 2, 3}, {0, 3, 4}, {0, 4, 1}};
  CHECK(may(fan, 0, 1));
}

TEST_CASE("an edge with three faces collapses only where its ends share no more") {
  // Three leaves of two faces each on the edge 0 1.
  const std::vector<FaceVertices> leaves{{0, 1, 2}, {0, 1, 3}, {0, 1, 4}, {1, 5, 2}, {1, 6, 3},
                                         {1, 7, 4}, {0, 2, 8}, {0, 3, 9}, {0, 4, 10}};
  CHECK(may(leaves, 0, 1));
  // A further way from 0 to 1, beside the edge.
  std::vector<FaceVertices> more = leaves;
  more.push_back({0, 11, 12});
  more.push_back({1, 11, 13});
  CHECK_FALSE(may(more, 0, 1));
}

TEST_CASE("a boundary is where an edge has not two faces") {
  const std::vector<FaceVertices> fan{{0, 1, 2}, {0, 2, 3}, {0, 3, 4}, {0, 4, 1}};
  TileMesh mesh = mesh_of(fan);
  Legality legality(mesh, 0);
  CHECK_FALSE(legality.at_boundary(0));
  for (VertexNumber v = 1; v < 5; ++v) CHECK(legality.at_boundary(v));
}

TEST_CASE(
    "no legal collapse makes a crowded edge or a face twice, or changes what the surface is") {
  Random random(840);
  std::uint64_t collapses = 0;
  for (int round = 0; round < 1500; ++round) {
    const auto vertices = static_cast<VertexNumber>(random.between(5, 16));
    TileMesh mesh = mesh_of(random_mesh(random, vertices, random.between(4, 60)));
    std::vector<FaceVertices> faces = live_faces(mesh);
    for (int tries = 0; tries < 40 && !faces.empty(); ++tries) {
      const FaceVertices face = random.one_of(faces);
      const std::size_t corner = random.below(3);
      const VertexNumber a = face[corner];
      const VertexNumber b = face[(corner + random.between(1, 2)) % 3];
      Legality legality(mesh, 0);
      if (!legality.keeps_surface(star_of(mesh, a, b))) continue;
      ++collapses;
      const std::map<Edge, unsigned> before = edges_of(faces);
      const int euler = euler_characteristic(faces);
      // A face at this edge alone, which goes with both of its other edges.
      const bool lonely = std::any_of(faces.begin(), faces.end(), [&](const FaceVertices& f) {
        unsigned sides = 0;
        for (std::size_t i = 0; i < 3; ++i) {
          const Edge side = std::minmax(f[i], f[(i + 1) % 3]);
          if (side != Edge(std::minmax(a, b))) sides += before.at(side) == 1;
        }
        return sides == 2 &&
               std::count(f.begin(), f.end(), a) + std::count(f.begin(), f.end(), b) == 2;
      });
      mesh.collapse({a, b, {}});
      faces = live_faces(mesh);
      const Defects defects = defects_of(faces);
      REQUIRE(defects.duplicates == 0);
      REQUIRE(defects.degenerate == 0);
      for (const auto& [each, count] : edges_of(faces)) {
        if (count <= 2) continue;
        const Edge edge = each;
        const auto crowded = [&](VertexNumber end) {
          const VertexNumber other = edge.first == a ? edge.second : edge.first;
          const auto found = before.find(std::minmax(end, other));
          return found != before.end() && found->second > 2;
        };
        const bool was =
            edge.first == a || edge.second == a ? crowded(a) || crowded(b) : before.at(edge) > 2;
        REQUIRE(was);
      }
      if (!lonely) REQUIRE(euler_characteristic(faces) == euler);
    }
  }
  CHECK(collapses > 3000);
}

TEST_CASE("a face turns by no more than the bound") {
  // Faces 0 1 2 and 0 2 3 stand on the edge 0 2; 3 is pulled in by 4 and goes somewhere.
  const std::vector<FaceVertices> faces{{0, 1, 2}, {0, 2, 3}, {3, 2, 4}, {3, 4, 0}};
  const std::vector<Point> positions{{0, 0, 0}, {1, -1, 0}, {2, 0, 0}, {1, 1, 0}, {1, 2, 0}};
  TileMesh mesh = mesh_of(faces, positions);
  for (const double bound : {10.0, 45.0, 80.0}) {
    Legality legality(mesh, std::cos(bound / 180 * std::numbers::pi));
    EdgeStar star = star_of(mesh, 3, 4);
    for (double angle = 0; angle < 180; angle += 1.25) {
      if (angle == bound) continue;
      const double radians = angle / 180 * std::numbers::pi;
      // The face 0 2 3 turns about its edge 0 2 by that angle.
      const bool good =
          legality.keeps_faces(star, {3, 4, {1, std::cos(radians), std::sin(radians)}});
      CAPTURE(bound, angle);
      CHECK(good == (angle < bound));
    }
    // And it must not become a line.
    CHECK_FALSE(legality.keeps_faces(star, {3, 4, {1, 0, 0}}));
    CHECK_FALSE(legality.keeps_faces(star, {3, 4, {1, 1e-11, 0}}));
    CHECK(legality.keeps_faces(star, {3, 4, {1, 1e-8, 0}}));
  }
}

}  // namespace winnow
