// Corners move to the first of all that are near them or near those: by trying all pairs.
#include "cluster/near_welder.hpp"

#include "cluster/near_links.hpp"
#include "cluster/resolution.hpp"
#include "cluster/weld_lattice.hpp"
#include "io/arena.hpp"
#include "support/job.hpp"
#include "support/ply_file.hpp"
#include "support/random.hpp"
#include "support/reading.hpp"
#include "support/sources.hpp"
#include "support/stl_file.hpp"

#include <algorithm>
#include <map>
#include <utility>

#include <catch2/catch.hpp>

namespace winnow::test {

namespace {

NearWeldMemory shares(std::uint64_t bytes) {
  return {bytes, bytes, bytes, bytes};
}

std::unique_ptr<NearWeldedReader> welded_reader(Job& job, const std::string& content,
                                                double distance, std::uint64_t memory) {
  return weld_near(job,
                   open_reader(job, std::make_unique<MemorySource>(content), Format::automatic,
                               Access::repeatedly, {usual_vertex_memory, 512}),
                   distance, shares(memory));
}

// The lattice that says which position is the first.
Grid grid_of(const std::string& content) {
  TestJob test;
  return in_arena(test.job, [&] {
    const auto reader =
        open_reader(test.job, std::make_unique<MemorySource>(content), Format::automatic,
                    Access::repeatedly, {usual_vertex_memory, 512});
    const auto count = reader->facts().vertices.value_or(reader->facts().faces.value_or(0));
    return lattice_over(measure_box_of_most(test.job, *reader, count));
  });
}

bool repeats_a_corner(const SeenFace& face) {
  const auto& [a, b, c] = face.corner;
  return a == b || a == c || b == c;
}

// Where each position goes, by the definition.
std::map<Point, Point> by_definition(const std::vector<SeenFace>& faces, const Grid& grid,
                                     double distance) {
  std::vector<Point> points;
  for (const SeenFace& face : faces) {
    if (!repeats_a_corner(face))
      points.insert(points.end(), face.corner.begin(), face.corner.end());
  }
  std::sort(points.begin(), points.end(), [&](const Point& a, const Point& b) {
    return std::pair(key_of(grid, a), a) < std::pair(key_of(grid, b), b);
  });
  points.erase(std::unique(points.begin(), points.end()), points.end());
  std::vector<std::size_t> first(points.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    first[i] = i;
    for (std::size_t k = 0; k < i; ++k) {
      if (first[k] == first[i] || !is_nearer(points[i], points[k], distance)) continue;
      const auto [low, high] = std::minmax({first[i], first[k]});
      std::replace(first.begin(), first.begin() + static_cast<std::ptrdiff_t>(i) + 1, high, low);
    }
  }
  std::map<Point, Point> to;
  for (std::size_t i = 0; i < points.size(); ++i) to[points[i]] = points[first[i]];
  return to;
}

void check_welded(const std::string& content, double distance) {
  const std::vector<SeenFace> before = faces_of(content);
  const Grid grid = grid_of(content);
  const std::map<Point, Point> to = by_definition(before, grid, distance);
  std::size_t merged = 0;
  for (const auto& [from, place] : to) merged += from != place ? 1 : 0;
  std::vector<SeenFace> right = before;
  std::uint64_t collapsed = 0;
  for (SeenFace& face : right) {
    const bool repeated = repeats_a_corner(face);
    for (Point& corner : face.corner) {
      if (to.contains(corner)) corner = to.at(corner);
    }
    if (repeated || !repeats_a_corner(face)) continue;
    face.status = FaceStatus::cropped;
    ++collapsed;
  }
  for (const unsigned threads : {1U, 3U}) {
    for (const std::uint64_t memory : {mebibyte, 16 * mebibyte}) {
      TestJob test({.threads = threads});
      in_arena(test.job, [&] {
        const auto reader = welded_reader(test.job, content, distance, memory);
        CAPTURE(threads, memory, distance);
        CHECK(difference(read_faces(test.job, *reader), right).empty());
        CHECK(reader->merged() == merged);
        CHECK(reader->collapsed() == collapsed);
        // A second pass gives the same.
        CHECK(difference(read_faces(test.job, *reader), right).empty());
        CHECK(reader->collapsed() == collapsed);
      });
    }
  }
}

}  // namespace

TEST_CASE("corners of floats move as all pairs say") {
  Random random(4711);
  for (int run = 0; run < 12; ++run) {
    std::vector<Triangle> faces = random_triangles(random, random.between(1, 250), 1);
    for (Triangle& face : faces) {
      for (Point& corner : face) {
        // Beside a corner of another face, and now and then far from all.
        const Triangle& other = random.one_of(faces);
        if (random.chance(0.6)) corner = other[random.below(3)];
        if (random.chance(0.5)) corner[random.below(3)] += random.real(-0.01, 0.01);
        if (random.chance(0.02)) corner[random.below(3)] = random.real(-1e9, 1e9);
        for (double& x : corner) x = static_cast<float>(x);
      }
    }
    check_welded(binary_stl(faces), random.chance(0.5) ? 0.01 : random.real(0.001, 0.3));
  }
}

TEST_CASE("corners of doubles far from the origin move as all pairs say") {
  Random random(4712);
  PlyStyle style;
  style.coordinate.fill(PlyType::float64);
  for (int run = 0; run < 8; ++run) {
    Polygons mesh = random_polygons(random, random.between(3, 400), 300, 3, 1);
    for (Point& vertex : mesh.vertices) {
      if (random.chance(0.5)) vertex = random.one_of(mesh.vertices);
      for (double& x : vertex) x += 1e-7 * random.real(-1, 1);
    }
    // Where a double has steps of a 2^-31st.
    for (Point& vertex : mesh.vertices) vertex = vertex + Point{4e5, 5e6, -3e6};
    check_welded(ply_file(mesh, style), run % 2 == 0 ? 1.3e-7 : 0.02);
  }
}

TEST_CASE("a distance below the steps of the numbers joins nothing") {
  Polygons mesh{{{1e300, 0, 0}, {-1e300, 1, 0}, {0, 1e-300, 0}, {1e300, 1, 1e-300}},
                {{0, 1, 2}, {1, 2, 3}}};
  PlyStyle style;
  style.coordinate.fill(PlyType::float64);
  check_welded(ply_file(mesh, style), 1e-9);
  check_welded(ply_file(mesh, style), 1e-150);
}

TEST_CASE("vertices that no face uses join nothing") {
  // A stepping stone between two faces, which only a file with vertices can have.
  Polygons mesh{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1.5, 0, 0}, {2, 0, 0}, {3, 0, 0}, {2, 1, 0}},
                {{0, 1, 2}, {4, 5, 6}}};
  TestJob test;
  in_arena(test.job, [&] {
    const auto reader = welded_reader(test.job, ply_file(mesh, {}), 0.6, mebibyte);
    CHECK(reader->merged() == 0);
  });
}

}  // namespace winnow::test
