// The chains of a tile's mesh say at any time what a plain list of faces says, also where no
// surface is.
#include "decimate/tile_mesh.hpp"

#include "decimate/edge_star.hpp"
#include "support/random.hpp"

#include <algorithm>
#include <map>
#include <set>

#include <catch2/catch.hpp>

namespace winnow {

namespace {

// Faces anywhere between few vertices: fans that meet in points, edges with many faces, faces
// twice.
std::vector<FaceVertices> random_faces(test::Random& random, VertexNumber vertices,
                                       std::size_t count) {
  std::vector<FaceVertices> faces;
  while (faces.size() < count) {
    FaceVertices face{};
    for (VertexNumber& v : face) v = static_cast<VertexNumber>(random.below(vertices));
    if (face[0] == face[1] || face[1] == face[2] || face[2] == face[0]) continue;
    faces.push_back(face);
    if (random.chance(0.1) && faces.size() < count) faces.push_back({face[0], face[2], face[1]});
  }
  return faces;
}

struct NaiveMesh {
  std::vector<FaceVertices> faces;  // as they were numbered
  std::vector<bool> gone;
  std::vector<Point> positions;

  [[nodiscard]] bool has(std::size_t f, VertexNumber v) const {
    return !gone[f] && std::count(faces[f].begin(), faces[f].end(), v) > 0;
  }
  unsigned collapse(const Collapse& edge) {
    unsigned removed = 0;
    for (std::size_t f = 0; f < faces.size(); ++f) {
      if (!has(f, edge.removed)) continue;
      if (has(f, edge.kept)) {
        gone[f] = true;
        ++removed;
      } else {
        std::replace(faces[f].begin(), faces[f].end(), edge.removed, edge.kept);
      }
    }
    positions[edge.kept] = edge.position;
    return removed;
  }
};

void check_same(TileMesh& mesh, const NaiveMesh& naive) {
  REQUIRE(mesh.live_faces() ==
          static_cast<std::uint64_t>(std::count(naive.gone.begin(), naive.gone.end(), false)));
  for (FaceNumber f = 0; f < mesh.face_count(); ++f) {
    REQUIRE(mesh.removed(f) == naive.gone[f]);
    if (!naive.gone[f]) REQUIRE(mesh.face(f) == naive.faces[f]);
  }
  for (VertexNumber v = 0; v < mesh.vertex_count(); ++v) {
    std::multiset<FaceNumber> right;
    std::multiset<VertexNumber> right_neighbours;
    for (FaceNumber f = 0; f < mesh.face_count(); ++f) {
      if (!naive.has(f, v)) continue;
      right.insert(f);
      for (const VertexNumber w : naive.faces[f]) {
        if (w != v && right_neighbours.count(w) == 0) right_neighbours.insert(w);
      }
    }
    std::multiset<FaceNumber> found;
    mesh.for_each_face(v, [&](FaceNumber f) { found.insert(f); });
    REQUIRE(found == right);
    std::multiset<VertexNumber> neighbours;
    for (const VertexNumber w : mesh.neighbours(v)) neighbours.insert(w);
    REQUIRE(neighbours == right_neighbours);
    REQUIRE(mesh.has_faces(v) == !right.empty());
    REQUIRE(mesh.position(v) == naive.positions[v]);
  }
}

// What meeting() and all_edges_even() say, from the faces alone.
void check_meetings(TileMesh& mesh, const NaiveMesh& naive) {
  using Pair = std::set<VertexNumber>;
  const auto others = [&](VertexNumber v) {
    std::multiset<Pair> pairs;
    for (FaceNumber f = 0; f < naive.faces.size(); ++f) {
      if (!naive.has(f, v)) continue;
      Pair pair(naive.faces[f].begin(), naive.faces[f].end());
      pair.erase(v);
      pairs.insert(pair);
    }
    return pairs;
  };
  for (VertexNumber a = 0; a < mesh.vertex_count(); ++a) {
    const auto pairs_a = others(a);
    std::map<VertexNumber, unsigned> met;
    for (const Pair& pair : pairs_a) {
      for (const VertexNumber w : pair) ++met[w];
    }
    CHECK(mesh.all_edges_even(a) ==
          std::all_of(met.begin(), met.end(), [](const auto& of) { return of.second % 2 == 0; }));
    for (VertexNumber b = 0; b < mesh.vertex_count(); ++b) {
      if (a == b) continue;
      TileMesh::Meeting right;
      std::set<VertexNumber> common;
      for (const Pair& pair : others(b)) {
        right.faces += pair.count(a) != 0;
        right.falls_together |= pairs_a.count(pair) != 0;
        for (const VertexNumber w : pair) {
          if (met.count(w) != 0) common.insert(w);
        }
      }
      EdgeStar star(0);
      star.find(mesh, a, b);
      const TileMesh::Meeting found = mesh.meeting(star.of_kept(), b, star.of_removed());
      REQUIRE(found.faces == right.faces);
      REQUIRE(found.common == common.size());
      REQUIRE(found.falls_together == right.falls_together);
    }
  }
}

}  // namespace

TEST_CASE("after any collapses every vertex knows its faces and neighbours") {
  test::Random random(820);
  for (int round = 0; round < 40; ++round) {
    const auto vertices = static_cast<VertexNumber>(random.between(4, 30));
    NaiveMesh naive{random_faces(random, vertices, random.between(1, 60)), {}, {}};
    naive.gone.resize(naive.faces.size());
    naive.positions.resize(vertices);
    TileMesh mesh(naive.positions, naive.faces, std::vector<std::uint8_t>(vertices, 0));
    check_same(mesh, naive);
    check_meetings(mesh, naive);
    while (mesh.live_faces() > 0) {
      const auto f = static_cast<FaceNumber>(random.below(mesh.face_count()));
      if (mesh.removed(f)) continue;
      const std::size_t corner = random.below(3);
      const std::size_t other = (corner + random.between(1, 2)) % 3;
      const Collapse edge{
          mesh.face(f)[corner], mesh.face(f)[other], {random.unit(), random.unit(), random.unit()}};
      REQUIRE(mesh.collapse(edge) == naive.collapse(edge));
      check_same(mesh, naive);
    }
  }
}

}  // namespace winnow
