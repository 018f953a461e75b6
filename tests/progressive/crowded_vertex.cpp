// Splits at a vertex with very many faces take no time that grows with these.
#include "progressive/split_mesh.hpp"

#include <algorithm>
#include <vector>

#include <catch2/catch.hpp>

namespace winnow::test {

namespace {

using Faces = std::vector<FaceVertices>;

Faces sorted_faces(const SplitMesh& mesh) {
  Faces faces;
  for (std::uint32_t f = 0; f < mesh.faces(); ++f) faces.push_back(lowest_first(mesh.face(f)));
  std::sort(faces.begin(), faces.end());
  return faces;
}

// A vertex and a ring of others around it.
SplitMesh fan(std::uint32_t faces) {
  SplitMesh mesh(1);
  for (std::uint32_t v = 0; v <= faces; ++v) mesh.add_vertex(std::vector<std::uint32_t>{v});
  for (std::uint32_t f = 0; f < faces; ++f) mesh.add_face({0, 1 + f, 1 + (f + 1) % faces});
  return mesh;
}

// Cuts one of its first faces into three.
Split cut(std::uint32_t face, std::uint32_t faces, std::uint32_t added) {
  const std::uint32_t first = 1 + face, second = 1 + (face + 1) % faces;
  Split split;
  split.anchor = 0;
  split.new_vertices = 1;
  split.words = {added};
  split.moved = {{first, second}};
  split.restored = {{0, first, added}, {0, added, second}};
  return split;
}

}  // namespace

TEST_CASE("a vertex of very many faces is split, back and again", "[progressive]") {
  constexpr std::uint32_t count = 60'000;
  SplitMesh mesh = fan(count);
  const Faces before = sorted_faces(mesh);
  std::vector<SplitMesh::Undo> done;
  Faces right;
  for (std::uint32_t face = 0; face < count; ++face) {
    const Split split = cut(face, count, mesh.vertices());
    done.push_back(mesh.undo_of(split));
    right.push_back(lowest_first({mesh.vertices(), split.moved[0][0], split.moved[0][1]}));
    for (const FaceVertices& back : split.restored) right.push_back(lowest_first(back));
    REQUIRE(mesh.apply(split));
  }
  std::sort(right.begin(), right.end());
  CHECK((sorted_faces(mesh) == right));
  std::vector<Split> undone(count);
  for (std::uint32_t i = count; i-- > 0;) mesh.take_back(done[i], undone[i]);
  CHECK((sorted_faces(mesh) == before));
  for (const Split& split : undone) REQUIRE(mesh.apply(split));
  CHECK((sorted_faces(mesh) == right));
}

}  // namespace winnow::test
