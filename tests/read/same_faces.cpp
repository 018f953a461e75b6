// Mapped, read or piped, plain or packed: the same faces and positions.
#include "support/files.hpp"
#include "support/ply_file.hpp"
#include "support/reading.hpp"
#include "support/sanitized.hpp"
#include "support/sources.hpp"
#include "support/stl_file.hpp"
#include "support/text_meshes.hpp"

#include <catch2/catch.hpp>

namespace winnow {

using test::difference;

namespace {

struct Content {
  std::vector<test::SeenFace> faces;
  std::vector<test::Point> positions;
  std::optional<test::Point> first;
};

// The way a run reads, for each access.
Content read(test::TestJob& test, const std::string& path, Access access,
             const ReaderMemory& memory) {
  const auto reader =
      open_reader(test.job, open_source(test.job, path), Format::automatic, access, memory);
  Content content;
  if (access != Access::once) {
    content.positions = test::read_positions(test.job, *reader);
    if (access == Access::repeatedly)
      CHECK(difference(test::read_positions(test.job, *reader), content.positions) == "");
  } else {
    content.first = reader->first_finite_position();
  }
  content.faces = test::read_faces(test.job, *reader);
  if (access == Access::repeatedly) {
    reader->release_memory();
    CHECK(difference(test::read_faces(test.job, *reader), content.faces) == "");
    CHECK(difference(test::read_positions(test.job, *reader), content.positions) == "");
  }
  return content;
}

std::vector<std::string> example_files() {
  test::Random random(310);
  std::vector<std::string> files;
  const test::Polygons triangles = test::random_polygons(random, 8000, 20'000, 3);
  const test::Polygons polygons = test::random_polygons(random, 5000, 6000, 5);
  test::PlyStyle style;
  // More than a window of either kind.
  files.push_back(ply_file(test::random_polygons(random, 100'000, 150'000, 3), style));
  for (int form = 0; form < 3; ++form) {
    style = {};
    style.form = static_cast<PlyForm>(form);
    files.push_back(ply_file(triangles, style));
    style.coordinate.fill(PlyType::float64);
    style.faces_first = form == 1;
    files.push_back(ply_file(polygons, style));
    style.ornaments = &random;
    files.push_back(ply_file(polygons, style));
  }
  files.push_back(obj_file(polygons, {.random = &random}));
  files.push_back(off_file(polygons, {}));
  files.push_back(m_file(polygons, {.random = &random}));
  std::vector<test::Triangle> faces = test::random_triangles(random, 50'000);
  faces[0][0] = {NAN, 0, 0};
  faces[0][1][2] = INFINITY;
  files.push_back(test::binary_stl(faces));
  faces.resize(12'000);
  files.push_back(test::binary_stl(faces, {"solid", -1, "tail"}));
  files.push_back(test::ascii_stl(faces));
  return files;
}

}  // namespace

TEST_CASE("faces and positions do not depend on how the bytes come", "[slow][long]") {
  const test::Directory directory;
  const std::string path = directory.file("mesh");
  int number = 0;
  for (const std::string& file : example_files()) {
    if (test::sanitized && number++ % 6 != 0) continue;  // saves a minute
    test::write_file(path, file);
    const std::string packed = test::zstd_file(path);
    for (const Access access : {Access::once, Access::positions_first, Access::repeatedly}) {
      std::optional<Content> right;
      const auto same = [&](const char* how, const Content& content) {
        CAPTURE(number, how, static_cast<int>(access));
        if (!right) {
          right = content;
          REQUIRE(content.faces.size() > 10'000);
          REQUIRE((access == Access::once) == content.positions.empty());
          return;
        }
        CHECK(difference(content.faces, right->faces) == "");
        CHECK(difference(content.positions, right->positions) == "");
        CHECK(content.first == right->first);
      };
      // A small memory for vertices makes them move to scratch, and mapped pages be dropped.
      for (const ReaderMemory& memory : {ReaderMemory{std::uint64_t{1} << 18, 600},
                                         ReaderMemory{test::usual_vertex_memory, 8192}}) {
        for (const bool map : {false, true}) {
          test::TestJob test({.map_input = map});
          same(map ? "mapped" : "read", read(test, path, access, memory));
        }
        {
          const test::FedPipe pipe(file);
          test::TestJob test;
          same("pipe", read(test, pipe.path(), access, memory));
        }
        test::TestJob test({.threads = 1});
        same("packed", read(test, packed, access, memory));
      }
    }
    if (!test::sanitized) ++number;
  }
}

}  // namespace winnow
