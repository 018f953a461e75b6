// Open boundaries: all vertices stay where that is asked for, and hold their line where not.
#include "support/refined_file.hpp"

#include <algorithm>
#include <map>
#include <set>

#include <catch2/catch.hpp>

namespace winnow::test {

namespace {

std::set<Point> border_of(const PlainMesh& mesh) {
  std::map<std::pair<std::uint32_t, std::uint32_t>, int> edges;
  for (const auto& face : mesh.faces) {
    for (std::size_t i = 0; i < 3; ++i) ++edges[std::minmax(face[i], face[(i + 1) % 3])];
  }
  std::set<Point> boundary;
  for (const auto& [edge, faces] : edges) {
    if (faces != 1) continue;
    boundary.insert(mesh.vertices[edge.first].position);
    boundary.insert(mesh.vertices[edge.second].position);
  }
  return boundary;
}

}  // namespace

TEST_CASE("a boundary that is kept keeps every vertex", "[long]") {
  TestJob test;
  const std::set<Point> before = border_of(plain(welded(test.job, mountains())));
  CHECK(before.size() == 800);  // of 201 times 201 samples
  const Directory directory;
  for (const std::uint64_t wanted : {20'000, 3000}) {
    SimplifyOptions options = to_faces(wanted);
    options.boundary = Boundary::keep;
    const RefinedFile out = refine_file(directory, mountains(), options);
    CHECK(out.report.output.faces <= wanted);
    CHECK((border_of(out.mesh) == before));
  }
  SimplifyOptions options;
  options.target = Target::error(30);
  options.boundary = Boundary::keep;
  CHECK((border_of(refine_file(directory, mountains(), options).mesh) == before));
}

TEST_CASE("a boundary that is not kept loses vertices but hardly moves") {
  TestJob test;
  const PlainMesh original = plain(welded(test.job, mountains()));
  const Directory directory;
  const RefinedFile out = refine_file(directory, mountains(), to_faces(4000));
  const std::set<Point> after = border_of(out.mesh);
  CHECK(after.size() < 600);
  Box before;
  for (const IndexedVertex& vertex : original.vertices) before.add(vertex.position);
  // Seen from above the tile is a rectangle: so are its borders afterwards, to a part of a sample.
  const double sample = (before.high[0] - before.low[0]) / 200;
  double farthest = 0;
  for (const Point& p : after) {
    double nearest = std::numeric_limits<double>::infinity();
    for (const std::size_t axis : {0, 1}) {
      nearest = std::min(
          {nearest, std::abs(p[axis] - before.low[axis]), std::abs(p[axis] - before.high[axis])});
    }
    farthest = std::max(farthest, nearest);
  }
  CHECK(farthest < sample);
}

}  // namespace winnow::test
