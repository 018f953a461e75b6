// Faces whose vertices are near each other though the next face is anywhere: where any order will
// do, they come sorted by their vertices; each once, and the same.
#include "read/indexed/sorted_faces.hpp"

#include "read/indexed/buffered_faces.hpp"
#include "support/files.hpp"
#include "support/ply_file.hpp"
#include "support/reading.hpp"
#include "support/sanitized.hpp"
#include "support/sources.hpp"

#include <algorithm>
#include <tuple>

#include <catch2/catch.hpp>

namespace winnow {

using test::difference;

namespace {

constexpr std::size_t vertex_count = 30'000;
constexpr std::uint64_t vertex_memory = std::uint64_t{1} << 17;
constexpr ReaderMemory any_order{vertex_memory, 1000, true};

// Polygons over neighbouring vertices, in a scattered order; some name vertices that there are not,
// have too few corners, or reach across the mesh.
test::Polygons scattered(test::Random& random, std::size_t faces, std::size_t most) {
  test::Polygons mesh = test::random_polygons(random, vertex_count, 0, most);
  for (std::size_t i = 0; i < faces; ++i) {
    const auto near = static_cast<std::int64_t>(random.below(vertex_count - 100));
    std::vector<std::int64_t> face(random.between(3, most));
    for (std::int64_t& corner : face) corner = near + static_cast<std::int64_t>(random.below(100));
    if (random.chance(0.002))
      face[random.below(face.size())] = random.one_of<std::int64_t>({-1, vertex_count});
    if (random.chance(0.002)) face[0] = static_cast<std::int64_t>(random.below(vertex_count));
    if (random.chance(0.002)) face.resize(random.below(3));
    // What faces of too few corners are kept as.
    if (random.chance(0.001))
      face.assign(BufferedFaces::degenerate.begin(), BufferedFaces::degenerate.end());
    mesh.faces.push_back(face);
  }
  return mesh;
}

// In one order, whatever theirs was.
std::vector<test::SeenFace> ordered(std::vector<test::SeenFace> faces) {
  for (test::SeenFace& face : faces) {
    if (face.status != FaceStatus::good) face.corner = {};
  }
  std::sort(faces.begin(), faces.end(), [](const test::SeenFace& a, const test::SeenFace& b) {
    return std::tie(a.status, a.corner) < std::tie(b.status, b.corner);
  });
  return faces;
}

void check(const std::string& file, const std::vector<test::SeenFace>& right,
           const ReaderMemory& memory = any_order) {
  const std::vector<test::SeenFace> wanted = ordered(right);
  const std::uint64_t scratch = SortedFaces::bytes_a_face * right.size();
  const test::Directory directory;
  const std::string path = directory.file("mesh");
  test::write_file(path, file);
  for (const unsigned threads : {1U, 3U}) {
    if (test::sanitized && threads == 1) continue;  // fewer of the same calls
    for (const bool map : {false, true}) {
      test::TestJob test({.threads = threads, .map_input = map});
      {
        const auto reader = open_reader(test.job, open_source(test.job, path), Format::automatic,
                                        Access::repeatedly, memory);
        CAPTURE(threads, map);
        const std::vector<test::SeenFace> first = test::read_faces(test.job, *reader);
        REQUIRE(difference(ordered(first), wanted) == "");
        CHECK(test.job.scratch.written() >= scratch);
        test::check_later_passes(test.job, *reader, memory, first);
      }
      CHECK(test.job.budget.used() == 0);
    }
    const test::FedPipe pipe(file);
    test::TestJob test({.threads = threads});
    const auto reader = open_reader(test.job, open_source(test.job, pipe.path()), Format::automatic,
                                    Access::once, memory);
    REQUIRE(difference(ordered(test::read_faces(test.job, *reader)), wanted) == "");
    CHECK(test.job.scratch.written() >= scratch);
  }
}

}  // namespace

TEST_CASE("scattered faces of near vertices come sorted", "[slow]") {
  test::Random random(430);
  for (const std::size_t most : {3, 6}) {
    const test::Polygons mesh = scattered(random, 8'000, most);
    for (int form = 0; form < 3; ++form) {
      for (const PlyType coordinate : {PlyType::float32, PlyType::float64}) {
        test::PlyStyle style;
        style.form = static_cast<PlyForm>(form);
        style.coordinate.fill(coordinate);
        CAPTURE(most, form);
        check(ply_file(mesh, style), as_triangles(as_stored(mesh, style)));
      }
    }
  }
}

TEST_CASE("sorted faces are near the ones before them") {
  test::Random random(431);
  const test::Polygons mesh = scattered(random, 40'000, 3);
  const test::PlyStyle style;
  test::Polygons numbered = mesh;
  for (std::size_t i = 0; i < vertex_count; ++i)
    numbered.vertices[i] = {static_cast<double>(i), 0, 0};
  const auto far_apart = [&](const ReaderMemory& memory) {
    const std::vector<test::SeenFace> faces =
        test::faces_of(ply_file(numbered, style), {.memory = memory});
    std::size_t far = 0;
    for (std::size_t i = 1; i < faces.size(); ++i) {
      // A part of the memory that a pass may use, in vertices of 12 bytes.
      far += std::abs(faces[i].corner[0][0] - faces[i - 1].corner[0][0]) > vertex_memory / 12 / 8;
    }
    return static_cast<double>(far) / static_cast<double>(faces.size());
  };
  CHECK(far_apart({vertex_memory, 1000}) > 0.8);
  CHECK(far_apart(any_order) < 0.02);
}

TEST_CASE("whatever the memory, sorted faces are the same", "[slow][long]") {
  test::Random random(432);
  const test::Polygons mesh = scattered(random, 8'000, 4);
  const test::PlyStyle style;
  const std::string file = ply_file(mesh, style);
  const std::vector<test::SeenFace> right = ordered(as_triangles(as_stored(mesh, style)));
  for (std::uint64_t memory = 0; memory < std::uint64_t{1} << 21; memory = memory * 5 / 2 + 100) {
    for (const std::size_t batch : {8, 100, 8192}) {
      CAPTURE(memory, batch);
      REQUIRE(difference(ordered(test::faces_of(file, {.memory = {memory, batch, true}})), right) ==
              "");
    }
  }
}

TEST_CASE("faces that reach across the mesh keep their order, whether any will do or not") {
  test::Random random(433);
  const test::Polygons mesh = test::random_polygons(random, vertex_count, 30'000, 3);
  const test::PlyStyle style;
  const std::vector<test::SeenFace> seen =
      test::faces_of(ply_file(mesh, style), {.memory = any_order});
  CHECK(difference(seen, as_triangles(as_stored(mesh, style))) == "");
}

TEST_CASE("sorting faces is cancelled", "[threads]") {
  test::Random random(434);
  const std::string file = ply_file(scattered(random, 40'000, 3), {});
  test::TestJob test;
  test.context.progress = [&](const Progress& progress) {
    if (std::string(progress.stage) == "sort faces") test.context.cancel();
  };
  const Error error = test::error_of([&] {
    test::faces_of(test.job, std::make_unique<test::MemorySource>(file), {.memory = any_order});
  });
  CHECK(error.exit_code() == 130);
  CHECK(test.job.budget.used() == 0);
}

}  // namespace winnow
