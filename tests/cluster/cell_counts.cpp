// The cell size that gives a wanted number of faces.

#include "cluster/resolution.hpp"
#include "generate/generate.hpp"
#include "io/arena.hpp"
#include "read/for_each_batch.hpp"
#include "support/clustering.hpp"
#include "support/files.hpp"
#include "support/reading.hpp"
#include "support/sources.hpp"

#include <algorithm>
#include <cmath>

#include <catch2/catch.hpp>

namespace winnow {

using namespace test;

namespace {

std::unique_ptr<MeshReader> reader_of(Job& job, const std::string& path) {
  return open_reader(job, open_source(job, path), Format::automatic, Access::repeatedly,
                     {usual_vertex_memory, 8192});
}

CellCounts counts_of(Job& job, MeshReader& reader, std::uint64_t wanted) {
  return in_arena(job, [&] {
    const std::uint64_t positions =
        reader.facts().vertices.value_or(reader.facts().faces.value_or(0));
    return CellCounts(job, reader, positions, wanted);
  });
}

std::uint64_t faces_at(Job& job, MeshReader& reader, const Grid& grid) {
  return in_arena(job, [&] {
    const ClusterStyle style;
    const auto clusterer = Clusterer::make(job, {grid, Placement::mean, true}, style.memory);
    reader.begin_faces();
    for_each_face_batch(job, reader, [&](const FaceBatch& faces) { clusterer->add(faces); }, {});
    return clusterer->finish().mesh.face_count;
  });
}

void make(const std::string& path, Surface surface, std::uint64_t faces) {
  Context context;
  GenerateOptions options;
  options.surface = surface;
  options.faces = faces;
  generate(context, path, options);
}

}  // namespace

TEST_CASE("the cell found for a number of faces gives it within a tenth on scans") {
  const Directory directory;
  for (const char* name : {"scan.ply", "scan.stl"}) {
    const std::string path = directory.file(name);
    make(path, Surface::scan, 300'000);
    for (const std::uint64_t wanted : {300U, 3000U, 30'000U, 90'000U}) {
      TestJob here;
      const auto reader = reader_of(here.job, path);
      const CellCounts counts = counts_of(here.job, *reader, wanted);
      const double cell = counts.cell_for(static_cast<double>(wanted));
      const std::uint64_t got = faces_at(here.job, *reader, Grid::over(counts.box(), cell));
      CAPTURE(name, wanted, cell, got);
      CHECK(std::abs(static_cast<double>(got) / static_cast<double>(wanted) - 1) <= 0.1);
    }
  }
}

TEST_CASE("the cell is a function of the data alone", "[threads]") {
  const Directory directory;
  const std::string path = directory.file("terrain.ply");
  make(path, Surface::terrain, 100'000);
  double right = 0;
  for (const unsigned threads : {1U, 2U, 5U}) {
    for (const bool map : {false, true}) {
      for (const std::size_t batch : {std::size_t{500}, std::size_t{8192}}) {
        TestJob here({.threads = threads, .map_input = map});
        const auto reader = open_reader(here.job, open_source(here.job, path), Format::ply,
                                        Access::repeatedly, {usual_vertex_memory, batch});
        const double cell = counts_of(here.job, *reader, 5000).cell_for(5000);
        if (right == 0) right = cell;
        CAPTURE(threads, map, batch);
        CHECK(cell == right);
      }
    }
  }
}

TEST_CASE("more faces need smaller cells, and what is foretold fits what is found") {
  const Directory directory;
  const std::string path = directory.file("part.ply");
  make(path, Surface::part, 50'000);
  TestJob here;
  const auto reader = reader_of(here.job, path);
  const CellCounts counts = counts_of(here.job, *reader, 2000);
  double last = HUGE_VAL;
  for (double faces = 500; faces < 20'000; faces *= 1.3) {
    const double cell = counts.cell_for(faces);
    CAPTURE(faces, cell);
    CHECK(cell < last);
    CHECK(counts.expected_faces(cell) == Approx(faces).epsilon(1e-3));
    last = cell;
  }
}

TEST_CASE("the box is that of all finite positions") {
  TestJob here;
  const double nan = std::nan("");
  const std::vector<Point> points{{nan, 1e9, 0}, {1, 2, 3}, {HUGE_VAL, 0, 1e9},
                                  {-4, 5, -6},   {0, 0, 0}, {1e9, 1e9, -HUGE_VAL}};
  std::string text =
      "ply\nformat ascii 1.0\nelement vertex 6\nproperty double x\nproperty double y\nproperty "
      "double "
      "z\nend_header\n";
  for (const Point& p : points)
    text += std::to_string(p[0]) + " " + std::to_string(p[1]) + " " + std::to_string(p[2]) + "\n";
  const auto reader = open_reader(here.job, std::make_unique<MemorySource>(text), Format::ply,
                                  Access::repeatedly, {usual_vertex_memory, 8});
  const Box box = in_arena(here.job, [&] { return measure_box(here.job, *reader); });
  CHECK_FALSE(box.empty);
  CHECK(box.low == Point{-4, 0, -6});
  CHECK(box.high == Point{1, 5, 3});
  // No face uses any.
  CHECK(in_arena(here.job, [&] { return measure_box_of_faces(here.job, *reader); }).empty);
  CHECK(counts_of(here.job, *reader, 10).box().empty);
}

TEST_CASE("a single point, or none, asks for no impossible cell") {
  for (const char* vertices : {"", "7 7 7\n", "7 7 7\n7 7 7\n", "nan 1 2\n"}) {
    TestJob here;
    const auto lines = std::count(vertices, vertices + std::string(vertices).size(), '\n');
    const std::string text =
        "ply\nformat ascii 1.0\nelement vertex " + std::to_string(lines) +
        "\nproperty float x\nproperty float y\nproperty float z\nend_header\n" + vertices;
    const auto reader = open_reader(here.job, std::make_unique<MemorySource>(text), Format::ply,
                                    Access::repeatedly, {usual_vertex_memory, 8});
    const CellCounts counts = counts_of(here.job, *reader, 100);
    CAPTURE(vertices);
    CHECK(counts.cell_for(100) > 0);
    CHECK(std::isfinite(counts.cell_for(100)));
  }
}

}  // namespace winnow
