// Edges of a result are counted exactly, in any memory and whatever the order of its faces.
#include "measure/result_surface.hpp"

#include "io/arena.hpp"
#include "io/spool_records.hpp"
#include "support/job.hpp"
#include "support/random.hpp"

#include <array>
#include <cmath>
#include <map>
#include <vector>

#include <catch2/catch.hpp>

namespace winnow::test {

namespace {

using CornerNumbers = std::array<std::uint32_t, 3>;

struct Counted {
  ResultSurface surface;
  std::uint64_t spilled = 0;
  CountedSurface alone;  // without positions
};

Counted counted(const std::vector<Point>& vertices, const std::vector<CornerNumbers>& faces,
                std::uint64_t memory = 16 * mebibyte) {
  TestJob test;
  return in_arena(test.job, [&] {
    StoredMesh mesh;
    mesh.vertices = std::make_unique<VertexIndex>(test.job, 64 * mebibyte);
    for (const Point& p : vertices) {
      IndexedVertex vertex;
      vertex.position = p;
      mesh.vertices->append({&vertex, 1});
    }
    mesh.vertices->finish();
    mesh.faces = std::make_unique<Spool>(test.job, 64 * mebibyte);
    append_records<CornerNumbers>(*mesh.faces, faces);
    mesh.faces->finish();
    mesh.face_count = faces.size();
    const ResultSurface surface = measure_result(test.job, mesh, memory);
    const std::uint64_t spilled = test.job.scratch.written();
    return Counted{surface, spilled, count_surface(test.job, mesh, memory)};
  });
}

void check_by_definition(const std::vector<Point>& vertices,
                         const std::vector<CornerNumbers>& faces) {
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::pair<int, int>> sides;
  double area = 0;
  for (const CornerNumbers& face : faces) {
    for (std::size_t i = 0; i < 3; ++i) {
      const auto [low, high] = std::minmax({face[i], face[(i + 1) % 3]});
      auto& side = sides[{low, high}];
      ++(face[i] == low ? side.first : side.second);
    }
    area += length(doubled_area({vertices[face[0]], vertices[face[1]], vertices[face[2]]})) / 2;
  }
  SurfaceEdges right;
  bool closed = true;
  for (const auto& [edge, count] : sides) {
    const int all = count.first + count.second;
    ++right.total;
    right.boundary += all == 1 ? 1 : 0;
    right.non_manifold += all > 2 ? 1 : 0;
    closed &= count.first == count.second;
  }
  const Counted all = counted(vertices, faces);
  const ResultSurface& out = all.surface;
  CHECK(all.alone.edges.total == right.total);
  CHECK(all.alone.edges.boundary == right.boundary);
  CHECK(all.alone.edges.non_manifold == right.non_manifold);
  CHECK(all.alone.pieces == out.pieces);
  CHECK(out.edges.total == right.total);
  CHECK(out.edges.boundary == right.boundary);
  CHECK(out.edges.non_manifold == right.non_manifold);
  CHECK(out.closed == closed);
  CHECK(out.area == Approx(area));
}

std::vector<Point> random_vertices(Random& random, std::size_t count) {
  std::vector<Point> vertices(count);
  for (Point& p : vertices) p = {random.unit(), random.unit(), random.unit()};
  return vertices;
}

}  // namespace

TEST_CASE("edges of a result are counted as by definition") {
  Random random(31);
  for (int run = 0; run < 60; ++run) {
    const std::size_t count = random.between(3, 60);
    const std::vector<Point> vertices = random_vertices(random, count);
    std::vector<CornerNumbers> faces;
    for (std::size_t i = random.between(1, 120); i > 0; --i) {
      CornerNumbers face{};
      do {
        for (std::uint32_t& v : face) v = static_cast<std::uint32_t>(random.below(count));
      } while (face[0] == face[1] || face[1] == face[2] || face[0] == face[2]);
      std::rotate(face.begin(), std::min_element(face.begin(), face.end()), face.end());
      faces.push_back(face);
      if (random.chance(0.3)) faces.push_back({face[0], face[2], face[1]});
    }
    CAPTURE(run, count, faces.size());
    if (run % 3 == 0) random.shuffle(faces);
    if (run % 3 != 0) std::sort(faces.begin(), faces.end());
    check_by_definition(vertices, faces);
  }
}

TEST_CASE("a closed surface is called closed and one without a face is not") {
  const std::vector<Point> vertices{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  std::vector<CornerNumbers> faces{{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}};
  CHECK(counted(vertices, faces).surface.closed);
  faces.pop_back();
  CHECK_FALSE(counted(vertices, faces).surface.closed);
  CHECK(counted(vertices, faces).surface.edges.boundary == 3);
}

TEST_CASE("any number of faces around a vertex are counted in any memory") {
  // A fan of 200,000 faces around vertex 0, and its mirror.
  constexpr std::uint32_t count = 200'000;
  std::vector<Point> vertices(count + 1);
  std::vector<CornerNumbers> faces;
  for (std::uint32_t i = 1; i <= count; ++i) {
    vertices[i] = {std::cos(i * 1e-5), std::sin(i * 1e-5), 0.1};
    if (i > 1) faces.push_back({0, i - 1, i});
  }
  const Counted large = counted(vertices, faces);
  const Counted small = counted(vertices, faces, mebibyte / 2);
  // Edges of a hub are more than a part's share, so some are sorted in runs anyway.
  CHECK(small.spilled > 4 * large.spilled);
  for (const Counted& one : {large, small}) {
    CHECK(one.surface.edges.total == 2 * count - 1);
    CHECK(one.surface.edges.boundary == count + 1);
    CHECK(one.surface.edges.non_manifold == 0);
  }
}

}  // namespace winnow::test
