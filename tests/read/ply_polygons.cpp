// Polygons become triangles, wherever batches end.
#include "support/ply_file.hpp"
#include "support/reading.hpp"
#include "support/sources.hpp"

#include <catch2/catch.hpp>

namespace winnow {

using test::difference;

namespace {

test::ReadStyle with_batches(std::size_t faces) {
  return {Format::automatic, Access::once, {test::usual_vertex_memory, faces}};
}

// Stretches of triangles, which have a fast way of their own, with other polygons between.
test::Polygons mixed(test::Random& random, std::size_t records) {
  test::Polygons mesh = test::random_polygons(random, 300, 0, 3);
  while (mesh.faces.size() < records) {
    const std::size_t stretch = random.one_of<std::size_t>({0, 1, 2, 7, 8, 9, 511, 512, 513, 1000});
    for (std::size_t i = 0; i < stretch + 1; ++i) {
      const std::size_t corners =
          i < stretch ? 3 : random.one_of<std::size_t>({0, 1, 2, 4, 5, 20, 200, 255});
      std::vector<std::int64_t> polygon(corners);
      for (std::int64_t& index : polygon) index = static_cast<std::int64_t>(random.below(300));
      mesh.faces.push_back(polygon);
    }
  }
  return mesh;
}

}  // namespace

TEST_CASE("triangles and other polygons mix across the ends of batches") {
  test::Random random(220);
  for (int round = 0; round < 12; ++round) {
    const test::Polygons mesh = mixed(random, 3000);
    for (int form = 0; form < 3; ++form) {
      test::PlyStyle style;
      style.form = static_cast<PlyForm>(form);
      const std::string file = ply_file(mesh, style);
      const std::vector<test::SeenFace> right = as_triangles(as_stored(mesh, style));
      for (const std::size_t batch : {std::size_t{8}, std::size_t{100}, std::size_t{512},
                                      std::size_t{1000}, std::size_t{8192}}) {
        CAPTURE(round, form, batch);
        REQUIRE(difference(test::faces_of(file, with_batches(batch)), right) == "");
        REQUIRE(difference(test::faces_of_pipe(file, with_batches(batch)), right) == "");
      }
    }
  }
}

TEST_CASE("one polygon may be longer than a batch") {
  test::Random random(221);
  test::Polygons mesh = test::random_polygons(random, 1000, 2, 3);
  for (const std::size_t corners : {60'000, 3, 30'000, 5}) {
    std::vector<std::int64_t> polygon(corners);
    for (std::int64_t& index : polygon) index = static_cast<std::int64_t>(random.below(1000));
    mesh.faces.push_back(polygon);
  }
  for (int form = 0; form < 3; ++form) {
    for (const PlyType count : {PlyType::uint16, PlyType::int32, PlyType::uint32}) {
      test::PlyStyle style;
      style.form = static_cast<PlyForm>(form);
      style.count = count;
      CAPTURE(form, static_cast<int>(count));
      CHECK(difference(test::faces_of(ply_file(mesh, style), with_batches(1000)),
                       as_triangles(as_stored(mesh, style))) == "");
    }
  }
}

TEST_CASE("a face of fewer than three corners is counted, and read over") {
  test::Polygons mesh;
  mesh.vertices = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}};
  mesh.faces = {{0, 1, 2}, {}, {1}, {1, 2}, {2, 1, 3}, {0, 3}};
  for (int form = 0; form < 3; ++form) {
    for (const bool faces_first : {false, true}) {
      test::PlyStyle style;
      style.form = static_cast<PlyForm>(form);
      style.faces_first = faces_first;
      const std::vector<test::SeenFace> seen = test::faces_of(ply_file(mesh, style));
      CAPTURE(form, faces_first);
      CHECK(difference(seen, as_triangles(mesh)) == "");
    }
  }
}

TEST_CASE("a negative length of a list is none") {
  test::PlyStyle style;
  style.count = PlyType::int8;
  test::Polygons mesh;
  mesh.vertices = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  mesh.faces = {{0, 1, 2}, {}, {0, 2, 1}};
  std::string file = ply_file(mesh, style);
  const std::size_t empty = file.size() - 13 - 1;
  REQUIRE(file[empty] == 0);
  file[empty] = static_cast<char>(-5);
  CHECK(difference(test::faces_of(file), as_triangles(mesh)) == "");
}

TEST_CASE("no batch is larger than was asked for but by one polygon") {
  test::Random random(222);
  const test::Polygons mesh = mixed(random, 3000);
  for (int form = 0; form < 3; ++form) {
    test::PlyStyle style;
    style.form = static_cast<PlyForm>(form);
    test::TestJob test;
    for (const std::size_t most : {std::size_t{16}, std::size_t{1000}}) {
      const auto reader =
          open_reader(test.job, std::make_unique<test::MemorySource>(ply_file(mesh, style)),
                      Format::ply, Access::once, {test::usual_vertex_memory, most});
      reader->begin_faces();
      for (RawBatch batch; reader->next_faces(batch);) {
        REQUIRE(batch.count < most + 255 - 2);
        REQUIRE(batch.count > 0);
      }
    }
  }
}

}  // namespace winnow
