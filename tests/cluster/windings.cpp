// Which way the faces of a result are turned.
#include "support/clustering.hpp"

#include <map>

#include <catch2/catch.hpp>

namespace winnow {

using namespace test;

namespace {

// Below this a normal says nothing: the same number as in the code, and the page that says why.
constexpr double shortest_normal = 0.1;

// Of the normals that are written: of one unit, or, where a cell's own nearly cancel, as short as
// they are.
Point mean_normal(const PlainMesh& mesh, std::size_t face) {
  Point mean{};
  for (const std::uint32_t index : mesh.faces[face]) {
    const auto& [x, y, z] = mesh.vertices[index].normal;
    const Point normal{x, y, z};
    mean = mean + (1 / (length(normal) < shortest_normal ? 3 : 3 * length(normal))) * normal;
  }
  return mean;
}

std::size_t faces_that_show_their_backs(const PlainMesh& mesh) {
  std::size_t backs = 0;
  for (std::size_t i = 0; i < mesh.faces.size(); ++i) {
    const Point mean = mean_normal(mesh, i);
    const Point area = area_vector(mesh.triangle(i));
    if (length(mean) > shortest_normal * 1.001 && dot(area, mean) < -1e-12 * length(area)) ++backs;
  }
  return backs;
}

// Opposite pairs, and windings by the net count, as the definition says; keys in ascending order.
struct Fusing {
  std::uint64_t fused = 0;
  std::map<std::array<CellKey, 3>, bool> along;
};

Fusing fuse(const std::vector<Triangle>& faces, const Grid& grid) {
  std::map<std::array<CellKey, 3>, std::array<std::uint64_t, 2>> counts;
  for (const Triangle& face : faces) {
    std::array<CellKey, 3> cell{key_of(grid, face[0]), key_of(grid, face[1]),
                                key_of(grid, face[2])};
    if (cell[0] == cell[1] || cell[1] == cell[2] || cell[0] == cell[2]) continue;
    while (cell[0] > cell[1] || cell[0] > cell[2])
      std::rotate(cell.begin(), cell.begin() + 1, cell.end());
    const bool along = cell[1] < cell[2];
    if (!along) std::swap(cell[1], cell[2]);
    ++counts[cell][along ? 0 : 1];
  }
  Fusing out;
  for (const auto& [cell, count] : counts) {
    out.fused += std::min(count[0], count[1]);
    out.along[cell] = count[0] >= count[1];
  }
  return out;
}

// How many faces of the result are not turned as their net count was.
std::uint64_t turned_by(const PlainMesh& mesh, const Fusing& fusing) {
  std::uint64_t turned = 0;
  for (const auto& face : mesh.faces) {
    std::array<CellKey, 3> cell{mesh.vertices[face[0]].key, mesh.vertices[face[1]].key,
                                mesh.vertices[face[2]].key};
    const bool along = cell[1] < cell[2];
    if (!along) std::swap(cell[1], cell[2]);
    turned += fusing.along.at(cell) == along ? 0 : 1;
  }
  return turned;
}

}  // namespace

TEST_CASE("faces of a result agree with the mean normal of their cells") {
  Random random(480);
  for (const double cell : {0.3, 0.1, 0.03}) {
    for (const double wrong :
         {0.0, 0.1, 0.3}) {  // part of the input's faces that is turned the wrong way
      std::vector<Triangle> faces = ball(80, 0.1);
      for (Triangle& face : faces) {
        if (random.chance(wrong)) face = turned(face);
      }
      for (const Placement placement : {Placement::mean, Placement::quadric}) {
        const ClusterSettings settings = settings_over(faces, cell, placement);
        const PlainMesh mesh = cluster(faces, settings);
        const Fusing fusing = fuse(faces, settings.grid);
        CAPTURE(cell, wrong, static_cast<int>(placement));
        CHECK(faces_that_show_their_backs(mesh) == 0);
        CHECK(mesh.turned == turned_by(mesh, fusing));
        CHECK(mesh.fused == fusing.fused);
        if (wrong > 0.2 && cell < 0.2) CHECK(mesh.turned > 0);
        // Where a cell holds several faces, or none is turned, they look outwards; but for a few
        // that stand nearly upright between two cells.
        if (wrong >= 0.2 || cell >= 0.2 || (wrong > 0 && cell != 0.1)) continue;
        std::size_t inwards = 0;
        for (std::size_t i = 0; i < mesh.faces.size(); ++i) {
          const Triangle face = mesh.triangle(i);
          inwards += dot(area_vector(face), face[0] + face[1] + face[2]) > 0 ? 0 : 1;
        }
        CHECK(inwards * 100 < mesh.faces.size());
      }
    }
  }
}

TEST_CASE("a soup of any windings obeys the same rules") {
  Random random(481);
  for (const double size : {0.1, 0.4}) {
    const std::vector<Triangle> faces = soup(random, 10'000, size);
    const ClusterSettings settings = settings_over(faces, 0.15);
    const PlainMesh mesh = cluster(faces, settings);
    const Fusing fusing = fuse(faces, settings.grid);
    CHECK(faces_that_show_their_backs(mesh) == 0);
    CHECK(mesh.turned == turned_by(mesh, fusing));
    CHECK(mesh.fused == fusing.fused);
    CHECK(mesh.fused > 0);
  }
}

TEST_CASE("a sheet folded onto itself fuses in pairs") {
  const std::vector<Triangle> up = sheet(20);
  const ClusterSettings settings = settings_over(up, 0.0499);
  const std::size_t single = cluster(up, settings).faces.size();
  REQUIRE(single > 600);

  std::vector<Triangle> folded = up;
  for (const Triangle& face : up) folded.push_back(turned(face));
  const PlainMesh both = cluster(folded, settings);
  CHECK(both.faces.size() == single);
  CHECK(both.fused == single);
  // Neither side is more: the order of the keys decides, and no normal says otherwise.
  CHECK(both.turned == 0);
  for (const auto& face : both.faces) CHECK((face[0] < face[1] && face[1] < face[2]));

  std::vector<Triangle> twice = up;
  twice.insert(twice.end(), up.begin(), up.end());
  CHECK(cluster(twice, settings).fused == 0);

  // Two up, one down: one pair, and up wins.
  folded.insert(folded.end(), up.begin(), up.end());
  const PlainMesh three = cluster(folded, settings);
  CHECK(three.fused == single);
  for (std::size_t i = 0; i < three.faces.size(); ++i) CHECK(area_vector(three.triangle(i))[2] > 0);
}

TEST_CASE("vertex normals are the mean of the faces' around them") {
  const std::vector<Triangle> faces = ball(80);
  const PlainMesh mesh = cluster(faces, settings_over(faces, 0.08));
  for (const IndexedVertex& vertex : mesh.vertices) {
    const Point n{vertex.normal[0], vertex.normal[1], vertex.normal[2]};
    CHECK(length(n) > 0.98);
    CHECK(length(n) <= 1.00001);
    CHECK(dot(n, vertex.position) / length(n) / length(vertex.position) > 0.99);
  }
}

}  // namespace winnow
