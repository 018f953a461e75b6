// Equal positions become one vertex, and nothing else does.
#include "cluster/welder.hpp"
#include "meshes.hpp"
#include "support/ply_file.hpp"
#include "support/refining.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include <catch2/catch.hpp>

namespace winnow {

using namespace test;

namespace {

PlainMesh weld_polygons(const Polygons& polygons, unsigned threads = 2) {
  PlyStyle style;
  style.coordinate.fill(PlyType::float64);
  TestJob test({.threads = threads});
  return plain(weld_content(test.job, ply_file(polygons, style)));
}

Triangle from_lowest(Triangle face) {
  std::rotate(face.begin(), std::min_element(face.begin(), face.end()), face.end());
  return face;
}

std::vector<Triangle> faces_of(const PlainMesh& mesh) {
  std::vector<Triangle> faces;
  for (std::size_t f = 0; f < mesh.faces.size(); ++f)
    faces.push_back(from_lowest(mesh.triangle(f)));
  std::sort(faces.begin(), faces.end());
  return faces;
}

// The same by the definition: of each three positions one face, which passes them as most do. Both
// windings alike: then the result may take either, and none is expected here.
std::vector<Triangle> by_definition(const Polygons& polygons) {
  std::map<Triangle, int> net;  // by sorted corners; above 0: along the sorted order
  for (const auto& face : polygons.faces) {
    Triangle corner{};
    for (std::size_t i = 0; i < 3; ++i) {
      corner[i] = polygons.vertices[static_cast<std::size_t>(face[i])];
      for (double& x : corner[i]) x += 0.0;
    }
    Triangle sorted = corner;
    std::sort(sorted.begin(), sorted.end());
    if (sorted[0] == sorted[1] || sorted[1] == sorted[2]) continue;
    net[sorted] += from_lowest(corner) == sorted ? 1 : -1;
  }
  std::vector<Triangle> faces;
  for (const auto& [face, sign] : net) {
    CHECK(sign != 0);
    faces.push_back(sign > 0 ? face : Triangle{face[0], face[2], face[1]});
  }
  std::sort(faces.begin(), faces.end());
  return faces;
}

}  // namespace

TEST_CASE("equal positions become one vertex and faces of the same three become one") {
  Random random(890);
  for (const std::size_t places : {3, 10, 400}) {
    // Positions many times over, as STL has them, some with a zero below zero.
    Polygons polygons;
    std::vector<Point> place(places);
    for (Point& p : place) {
      for (double& x : p) x = random.chance(0.3) ? 0.0 : random.real(-5, 5);
    }
    std::set<Triangle> seen;
    std::set<Point> used;
    for (std::size_t i = 0; i < 10 * places; ++i) {
      std::vector<std::int64_t> face;
      Triangle sorted{random.one_of(place), random.one_of(place), random.one_of(place)};
      // Each three of positions an odd number of times, so that one winding wins; some turned.
      Triangle corners = sorted;
      std::sort(sorted.begin(), sorted.end());
      if (!seen.insert(sorted).second) continue;
      for (int copy = random.chance(0.3) ? 3 : 1; copy > 0; --copy) {
        face.clear();
        if (random.chance(0.3)) std::swap(corners[1], corners[2]);
        std::rotate(corners.begin(), corners.begin() + static_cast<std::ptrdiff_t>(random.below(3)),
                    corners.end());
        for (Point corner : corners) {
          used.insert(corner);
          for (double& x : corner) {
            if (x == 0 && random.chance(0.5)) x = -0.0;
          }
          face.push_back(static_cast<std::int64_t>(polygons.vertices.size()));
          polygons.vertices.push_back(corner);
        }
        polygons.faces.push_back(face);
      }
    }
    const std::vector<Triangle> right = by_definition(polygons);
    for (const unsigned threads : {1U, 4U}) {
      CAPTURE(places, threads);
      const PlainMesh mesh = weld_polygons(polygons, threads);
      CHECK(mesh.vertices.size() == used.size());
      CHECK((faces_of(mesh) == right));
      CHECK(mesh.counts.faces == polygons.faces.size());
      std::set<Point> positions;
      for (const IndexedVertex& vertex : mesh.vertices) {
        positions.insert(vertex.position);
        for (const double x : vertex.position) CHECK_FALSE((x == 0 && std::signbit(x)));
      }
      CHECK((positions == used));
      for (const auto& face : mesh.faces) CHECK(face[0] < std::min(face[1], face[2]));
    }
  }
}

TEST_CASE("positions that share a key of the lattice stay apart") {
  // Two clouds, each a billionth of the box wide, as where one vertex of a scan is far off.
  constexpr std::size_t places = 60'000;
  Random random(891);
  Polygons polygons;
  std::set<Point> used;
  for (std::size_t i = 0; i < places; ++i) {
    const double far = i % 2 == 0 ? 0 : 100;
    Point p{far, far, far};
    for (double& x : p) x += 1e-7 * random.unit();
    polygons.vertices.push_back(p);
    used.insert(p);
  }
  std::set<std::set<std::int64_t>> seen;
  for (int i = 0; i < 100'000; ++i) {
    std::vector<std::int64_t> face;
    for (int corner = 0; corner < 3; ++corner)
      face.push_back(static_cast<std::int64_t>(random.below(places)));
    const std::set<std::int64_t> corners(face.begin(), face.end());
    if (corners.size() == 3 && seen.insert(corners).second) polygons.faces.push_back(face);
  }
  const PlainMesh mesh = weld_polygons(polygons);
  std::set<CellKey> keys;
  std::set<Point> positions;
  for (const IndexedVertex& vertex : mesh.vertices) {
    keys.insert(vertex.key);
    positions.insert(vertex.position);
  }
  CHECK(keys.size() < 20);  // else nothing was tested
  CHECK((positions == used));
  CHECK(mesh.vertices.size() == used.size());
  CHECK((faces_of(mesh) == by_definition(polygons)));
}

TEST_CASE("faces turned against each other fuse and are counted") {
  Polygons polygons;
  polygons.vertices = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  polygons.faces = {{0, 1, 2}, {2, 1, 0}, {1, 2, 3}};
  const PlainMesh mesh = weld_polygons(polygons);
  CHECK(mesh.faces.size() == 2);
  CHECK(mesh.fused == 1);
}

TEST_CASE("welding counts and leaves out bad faces") {
  TestJob test;
  const PlainMesh mesh = plain(weld(test.job, test_data("bad_faces.ply")));
  const ClusterCounts& counts = mesh.counts;
  CHECK(mesh.faces.size() == 3);
  CHECK(counts.faces > 3);
  CHECK(counts.bad.total() == counts.faces - 3);
  CHECK(counts.bad.degenerate > 0);
  CHECK(counts.bad.non_finite > 0);
  CHECK(counts.bad.out_of_range > 0);
  CHECK(counts.first_bad.face < counts.faces);
}

TEST_CASE("welding keeps every face of a clean mesh") {
  for (const auto& [path, faces] : {std::pair(whale(), 100'000), {mountains(), 80'000}}) {
    TestJob test;
    const PlainMesh mesh = plain(weld(test.job, path));
    CHECK(mesh.faces.size() == static_cast<std::size_t>(faces));
    CHECK(mesh.counts.bad.total() == 0);
    CHECK(mesh.fused == 0);
  }
}

}  // namespace winnow
