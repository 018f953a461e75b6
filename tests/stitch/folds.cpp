// Faces that clustering laid on each other: folds go and leave a surface, walls that met are
// damage.
#include "stitch/damage.hpp"
#include "support/clustering.hpp"
#include "support/refining.hpp"
#include "support/shapes.hpp"

#include <algorithm>
#include <map>
#include <set>

#include <catch2/catch.hpp>

namespace winnow::test {

namespace {

struct Looked {
  PlainMesh mesh;
  Damage damage;
  std::uint64_t fallen = 0;  // faces that several fell onto
};

Looked look_at(const std::vector<Triangle>& faces, double cell) {
  TestJob test;
  ClusterSettings settings = settings_over(faces, cell);
  settings.for_refinement = true;
  const ClusterResult whole = clustered(test.job, faces, settings);
  Looked out;
  out.mesh = plain(whole);
  out.damage = *find_damage(test.job, whole.mesh, whole.several.get(), UINT64_MAX, cell / 2,
                            std::uint64_t{1} << 26);
  out.fallen = whole.several->size() / sizeof(FusedFace);
  return out;
}

bool among(const std::vector<std::uint32_t>& numbers, std::uint32_t number) {
  return std::binary_search(numbers.begin(), numbers.end(), number);
}

// Small bumps all over, which cells cut across.
std::vector<Triangle> rough_ball() {
  return ball(120, 0.01);
}

}  // namespace

TEST_CASE("the surface is closed where folds went") {
  for (const double cell : {0.05, 0.08, 0.13, 0.21}) {
    CAPTURE(cell);
    const Looked looked = look_at(rough_ball(), cell);
    const Damage& damage = looked.damage;
    CHECK(damage.folds.size() > 0);
    CHECK(damage.vertices.size() < looked.mesh.vertices.size() / 10);
    const std::set<FaceVertices> folds(damage.folds.begin(), damage.folds.end());
    // Sides of faces with no damaged vertex, one way less the other.
    std::map<std::array<std::uint32_t, 2>, int> sides;
    std::set<std::uint32_t> used;
    for (const FaceVertices& face : looked.mesh.faces) {
      if (folds.contains(face)) continue;
      used.insert(face.begin(), face.end());
      for (std::size_t i = 0; i < 3; ++i) {
        const std::uint32_t from = face[i];
        const std::uint32_t to = face[(i + 1) % 3];
        if (among(damage.vertices, from) || among(damage.vertices, to)) continue;
        CHECK(++sides[{from, to}] == 1);
      }
    }
    for (const auto& [side, times] : sides) CHECK(sides.contains({side[1], side[0]}));
    for (std::uint32_t v = 0; v < looked.mesh.vertices.size(); ++v)
      CHECK(used.contains(v) != among(damage.folded, v));
  }
}

TEST_CASE("walls that fell together are damage") {
  for (const double cell : {0.07, 0.11, 0.19}) {
    CAPTURE(cell);
    const Looked looked = look_at(triangles_of(shapes::plate(60, 0.0001)), cell);
    CHECK(looked.fallen > 0);
    CHECK(looked.damage.folds.empty());
    CHECK(looked.damage.vertices.size() == looked.mesh.vertices.size());
  }
  // Some parts of a shell meet in a cell, others do not.
  for (const double cell : {0.05, 0.1}) {
    CAPTURE(cell);
    const Looked looked = look_at(triangles_of(shapes::thin_shell(60, cell / 2)), cell);
    CHECK(looked.fallen > 100);
    CHECK(looked.damage.folds.size() < looked.fallen / 20);
  }
}

TEST_CASE("a piece that is one fold does not go") {
  // Two faces, back to back, in three cells.
  const Triangle face{Point{0.5, 0.5, 0.5}, Point{1.5, 0.5, 0.5}, Point{0.5, 1.5, 0.5}};
  const Triangle back{face[0], face[2], face[1]};
  const Looked looked =
      look_at({face, back, {Point{9, 9, 9}, Point{9.5, 9, 9}, Point{9, 9.5, 9}}}, 1);
  CHECK(looked.fallen == 1);
  CHECK(looked.damage.folds.empty());
  CHECK(looked.damage.vertices.size() == 3);
}

}  // namespace winnow::test
