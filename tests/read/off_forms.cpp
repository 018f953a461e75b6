// OFF with any header, comments anywhere, polygons, colours.
#include "support/job.hpp"
#include "support/reading.hpp"
#include "support/sources.hpp"
#include "support/text_meshes.hpp"

#include <catch2/catch.hpp>

namespace winnow {

using test::difference;
using test::faces_of;

TEST_CASE("an OFF of any style is the mesh that was written") {
  test::Random random(420);
  for (int round = 0; round < 60; ++round) {
    const test::Polygons mesh =
        test::random_polygons(random, random.between(1, 300), random.between(1, 300), 6);
    const std::string keyword =
        random.one_of<std::string>({"OFF", "COFF", "NOFF", "CNOFF", "STOFF", "STCNOFF"});
    for (const char* end : {"\n", "\r\n", "\r"}) {
      CAPTURE(round, end, keyword);
      const std::string file = off_file(mesh, {end, &random}, keyword);
      for (const std::size_t batch : {8, 64, 8192}) {
        const test::ReadStyle style{
            Format::automatic, Access::once, {test::usual_vertex_memory, batch}};
        REQUIRE(difference(faces_of(file, style), as_triangles(mesh)) == "");
        REQUIRE(difference(test::faces_of_pipe(file, style), as_triangles(mesh)) == "");
      }
    }
  }
}

TEST_CASE("headers of OFF") {
  const std::string body = "0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n";
  for (const char* header :
       {"OFF\n3 1 0\n", "OFF 3 1 0\n", "OFF\n\n# counts\n3 1 0 # so\n", "OFF\n3 1\n",
        "\t OFF3 1 3\n", "# comes first\n\nOFF\n3 1 0\n", "4OFF\n3 1 0\n", "OFF BINARY\n3 1 0\n",
        "NOFF\n3 1 0\n", "Off\n3 1 0\n", "oFF 3 1 0\n"}) {
    CAPTURE(header);
    const bool refused = std::string(header).find_first_of("4B") != std::string::npos;
    if (refused) {
      CHECK(test::error_of([&] { faces_of(header + body); }).kind() == ErrorKind::bad_input);
    } else {
      CHECK(faces_of(header + body).size() == 1);
    }
  }
  CHECK(
      std::string(test::error_of([] { faces_of("OFF BINARY\n" + std::string(200, '\1')); }).what())
          .find("binary OFF") != std::string::npos);
}

TEST_CASE("the header of an OFF may stretch over several blocks") {
  // Two numbers are no colour, which is said when the whole header was read.
  const std::string file = "STCOFF\n# " + std::string(3000, 'x') +
                           "\n3 1 0\n0 0 0 7 7 0 0\n1 0 0 7 7 0 0\n0 1 0 7 7 0 0\n3 0 1 2\n";
  test::TestJob test;
  const auto reader = open_reader(test.job, std::make_unique<test::MemorySource>(file),
                                  Format::automatic, Access::once, {test::usual_vertex_memory, 8});
  CHECK(test::read_faces(test.job, *reader).size() == 1);
  CHECK(reader->facts().offer.unread ==
        std::vector<std::string>{"colours", "texture coordinates", "numbers behind vertices"});
}

TEST_CASE("faces of an OFF that are none are told apart") {
  const std::vector<test::SeenFace> faces =
      faces_of("OFF\n3 5 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n2 0 1\n0\n3 0 1 3\n3 -1 0 1\n");
  REQUIRE(faces.size() == 5);
  CHECK(faces[0].status == FaceStatus::good);
  CHECK(faces[1].status == FaceStatus::degenerate);
  CHECK(faces[2].status == FaceStatus::degenerate);
  CHECK(faces[3].status == FaceStatus::out_of_range);
  CHECK(faces[4].status == FaceStatus::out_of_range);
}

}  // namespace winnow
