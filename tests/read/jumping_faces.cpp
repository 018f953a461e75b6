// Faces that jump over more vertices than memory has room for: the same faces as by looking each
// vertex up.
#include "support/files.hpp"
#include "support/ply_file.hpp"
#include "support/reading.hpp"
#include "support/sanitized.hpp"
#include "support/sources.hpp"
#include "support/text_meshes.hpp"

#include <catch2/catch.hpp>

namespace winnow {

using test::difference;

namespace {

constexpr std::size_t vertex_count = 30'000;

// Polygons over vertices anywhere, some of which there are not.
test::Polygons jumping(test::Random& random, std::size_t faces, std::size_t most) {
  test::Polygons mesh = test::random_polygons(random, vertex_count, faces, most);
  for (auto& face : mesh.faces) {
    if (random.chance(0.02))
      face[random.below(face.size())] = random.one_of<std::int64_t>({-1, vertex_count});
    if (random.chance(0.01)) face.resize(random.below(3));
  }
  return mesh;
}

// Too little for the vertices of any style.
constexpr ReaderMemory small_memory{std::uint64_t{1} << 16, 1000};

// Reads `file` in every way there is; every pass has to give `right`, from scratch.
void check(const std::string& file, const std::vector<test::SeenFace>& right,
           const ReaderMemory& memory = small_memory) {
  const test::Directory directory;
  const std::string path = directory.file("mesh");
  test::write_file(path, file);
  for (const Access access : {Access::once, Access::repeatedly}) {
    for (const unsigned threads : {1U, 3U}) {
      if (test::sanitized && threads == 1) continue;  // fewer of the same calls
      for (const bool map : {false, true}) {
        test::TestJob test({.threads = threads, .map_input = map});
        {
          const auto reader =
              open_reader(test.job, open_source(test.job, path), Format::automatic, access, memory);
          CAPTURE(threads, map);
          REQUIRE(difference(test::read_faces(test.job, *reader), right) == "");
          // All corners went through scratch, as numbers and as positions of at least three bytes.
          CHECK(test.job.scratch.written() >= 3 * 7 * right.size());
          test::check_later_passes(test.job, *reader, memory, right);
        }
        CHECK(test.job.budget.used() == 0);
      }
      const test::FedPipe pipe(file);
      test::TestJob test({.threads = threads});
      const auto reader = open_reader(test.job, open_source(test.job, pipe.path()),
                                      Format::automatic, access, memory);
      REQUIRE(difference(test::read_faces(test.job, *reader), right) == "");
      CHECK(test.job.scratch.written() >= 3 * 7 * right.size());
    }
  }
}

}  // namespace

TEST_CASE("triangles that jump", "[slow]") {
  test::Random random(410);
  const test::Polygons mesh = jumping(random, 20'000, 3);
  for (int form = 0; form < 3; ++form) {
    for (const PlyType coordinate : {PlyType::float32, PlyType::float64}) {
      test::PlyStyle style;
      style.form = static_cast<PlyForm>(form);
      style.coordinate.fill(coordinate);
      CAPTURE(form);
      check(ply_file(mesh, style), as_triangles(as_stored(mesh, style)));
    }
  }
}

TEST_CASE("triangles that jump in files of any style") {
  test::Random random(411);
  for (int round = 0; round < 6; ++round) {
    const test::Polygons mesh = jumping(random, 6000, 3);
    const test::PlyStyle style = random_ply_style(random, mesh);
    CAPTURE(round);
    check(ply_file(mesh, style), as_triangles(as_stored(mesh, style)));
  }
}

TEST_CASE("polygons and strips that jump", "[slow]") {
  test::Random random(412);
  for (int form = 0; form < 3; ++form) {
    test::PlyStyle style;
    style.form = static_cast<PlyForm>(form);
    test::Polygons mesh = jumping(random, 6000, 6);
    CAPTURE(form);
    check(ply_file(mesh, style), as_triangles(as_stored(mesh, style)));
    style.count = PlyType::int32;
    style.faces = "tristrips";
    for (auto& strip : mesh.faces)
      strip.resize(3 + random.below(20), static_cast<std::int64_t>(random.below(100)));
    check(ply_file(mesh, style), as_strips(as_stored(mesh, style)));
  }
}

TEST_CASE("faces that jump before their vertices come") {
  test::Random random(413);
  const test::Polygons mesh = jumping(random, 6000, 5);
  test::PlyStyle style;
  style.faces_first = true;
  check(ply_file(mesh, style), as_triangles(as_stored(mesh, style)));
}

TEST_CASE("faces of a text that jump", "[slow][long]") {
  test::Random random(414);
  const test::Polygons mesh = test::random_polygons(random, vertex_count, 10'000, 4);
  for (const std::string& file : {obj_file(mesh, {.random = &random}), off_file(mesh, {})}) {
    // By looking up.
    const std::vector<test::SeenFace> right = test::faces_of(file);
    check(file, right, {std::uint64_t{1} << 17, 1000});
  }
}

TEST_CASE("whatever the memory, faces that jump are the same", "[long]") {
  test::Random random(415);
  const test::Polygons mesh = jumping(random, 10'000, 3);
  const test::PlyStyle style;
  const std::string file = ply_file(mesh, style);
  const std::vector<test::SeenFace> right = as_triangles(as_stored(mesh, style));
  for (std::uint64_t memory = 0; memory < std::uint64_t{1} << 20; memory = memory * 5 / 2 + 100) {
    for (const std::size_t batch : {8, 100, 8192}) {
      CAPTURE(memory, batch);
      REQUIRE(difference(test::faces_of(file, {.memory = {memory, batch}}), right) == "");
    }
  }
}

TEST_CASE(
    "faces that jump only somewhere in a file are noticed, and those that do not are looked up") {
  test::Random random(416);
  test::Polygons mesh = test::random_polygons(random, vertex_count, 0, 3);
  const auto faces = static_cast<std::int64_t>(2 * vertex_count);
  for (std::int64_t i = 0; i < faces; ++i) {
    const std::int64_t near = i * static_cast<std::int64_t>(vertex_count - 200) / faces;
    mesh.faces.push_back({near, near + 1 + i % 100, near + 2 + i % 150});
  }
  const test::PlyStyle style;
  for (const double jumping_from : {1.0, 0.8, 0.5}) {
    for (std::size_t i = 0; i < mesh.faces.size(); ++i) {
      if (static_cast<double>(i) < jumping_from * static_cast<double>(faces)) continue;
      for (std::int64_t& corner : mesh.faces[i])
        corner = static_cast<std::int64_t>(random.below(vertex_count));
    }
    test::TestJob test;
    auto source = std::make_unique<test::MemorySource>(ply_file(mesh, style));
    const auto seen =
        test::faces_of(test.job, std::move(source), {.memory = {std::uint64_t{1} << 16, 1000}});
    CAPTURE(jumping_from);
    CHECK(difference(seen, as_triangles(as_stored(mesh, style))) == "");
    // The vertices themselves are kept there.
    CHECK((test.job.scratch.written() > 12 * vertex_count) == (jumping_from < 1));
  }
}

TEST_CASE("bringing the vertices of jumping faces together is cancelled", "[threads]") {
  test::Random random(417);
  const test::PlyStyle style;
  const std::string file = ply_file(jumping(random, 20'000, 3), style);
  for (const char* stage : {"sort corners", "look up corners"}) {
    test::TestJob test;
    test.context.progress = [&](const Progress& progress) {
      if (std::string(progress.stage) == stage) test.context.cancel();
    };
    const Error error = test::error_of([&] {
      test::faces_of(test.job, std::make_unique<test::MemorySource>(file),
                     {.memory = small_memory});
    });
    CHECK(error.exit_code() == 130);
    CHECK(test.job.budget.used() == 0);
  }
}

TEST_CASE("a file that is cut inside of faces that jump says so") {
  test::Random random(418);
  test::PlyStyle style;
  style.form = PlyForm::big_endian;
  const std::string file = ply_file(jumping(random, 20'000, 6), style);
  const std::string cut = file.substr(0, file.size() - 30'000);
  std::vector<std::string> messages;
  for (const ReaderMemory& memory : {small_memory, ReaderMemory{test::usual_vertex_memory, 1000}}) {
    const Error error = test::error_of([&] { test::faces_of_pipe(cut, {.memory = memory}); });
    CHECK(error.exit_code() == 3);
    messages.emplace_back(error.what());
  }
  CHECK(messages[0].find("inside face") != std::string::npos);
  CHECK(messages[0] == messages[1]);
}

}  // namespace winnow
