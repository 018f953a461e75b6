// .m: vertices by any numbers, in any order.
#include "support/job.hpp"
#include "support/reading.hpp"
#include "support/sources.hpp"
#include "support/text_meshes.hpp"

#include <catch2/catch.hpp>

namespace winnow {

using test::difference;
using test::faces_of;

TEST_CASE("a .m of any style is the mesh that was written") {
  test::Random random(430);
  for (int round = 0; round < 60; ++round) {
    test::Polygons mesh =
        test::random_polygons(random, random.between(1, 300), random.between(1, 300), 6);
    mesh.faces.push_back({0, -1, 0});
    for (const char* end : {"\n", "\r\n"}) {
      CAPTURE(round, end);
      const std::string file = m_file(mesh, {end, &random});
      for (const std::size_t batch : {8, 8192}) {
        const test::ReadStyle style{
            Format::automatic, Access::once, {test::usual_vertex_memory, batch}};
        REQUIRE(difference(faces_of(file, style), as_triangles(mesh)) == "");
        REQUIRE(difference(test::faces_of_pipe(file, style), as_triangles(mesh)) == "");
      }
    }
  }
}

TEST_CASE("numbers of vertices that do not fit into memory are found all the same", "[long]") {
  test::Random random(431);
  const test::Polygons mesh = test::random_polygons(random, 50'000, 3'000, 3);
  for (int round = 0; round < 4; ++round) {
    const std::string file = m_file(mesh, {"\n", &random});
    test::TestJob test;
    CHECK(difference(faces_of(test.job, std::make_unique<test::MemorySource>(file),
                              {Format::automatic, Access::once, {std::uint64_t{1} << 20, 2048}}),
                     as_triangles(mesh)) == "");
    CHECK(test.job.scratch.written() > 0);
  }
}

TEST_CASE("of vertices with the same number the last counts, a missing one is out of range") {
  const std::vector<test::SeenFace> faces = faces_of(
      "# made for a test\nVertex 1 0 0 0\nVertex 2 9 9 9\nVertex 5 0 1 0 {rgb=(1 0 0)}\nVertex 2 1 "
      "0 0\n"
      "Face 1 1 2 5\nFace 2 1 2 3\nFace 9 5 1\nFace 4 0 1 2 {matid=2}\nFace 5 1 2 -5\nFace 6 1 2 "
      "4294967295\n");
  REQUIRE(faces.size() == 6);
  CHECK(faces[0].status == FaceStatus::good);
  CHECK(faces[0].corner[1] == test::Point{1, 0, 0});
  CHECK(faces[2].status == FaceStatus::degenerate);
  for (const std::size_t missing : {1, 3, 4, 5})
    CHECK(faces[missing].status == FaceStatus::out_of_range);
}

}  // namespace winnow
