// Every way to write an OBJ gives the same faces.
#include "support/reading.hpp"
#include "support/sources.hpp"
#include "support/text_meshes.hpp"

#include <catch2/catch.hpp>

namespace winnow {

using test::difference;
using test::faces_of;

namespace {

std::vector<test::SeenFace> both_ways(const std::string& file) {
  const std::vector<test::SeenFace> faces = faces_of(file);
  CHECK(difference(test::faces_of_pipe(file), faces) == "");
  return faces;
}

}  // namespace

TEST_CASE("an OBJ of any style is the mesh that was written") {
  test::Random random(400);
  for (int round = 0; round < 60; ++round) {
    const test::Polygons mesh =
        test::random_polygons(random, random.between(1, 300), random.between(1, 300), 6);
    for (const char* end : {"\n", "\r\n", "\r"}) {
      CAPTURE(round, end);
      const std::string file = obj_file(mesh, {end, &random});
      // Blocks of a few lines, and of all.
      for (const std::size_t batch : {8, 64, 8192}) {
        const test::ReadStyle style{
            Format::automatic, Access::once, {test::usual_vertex_memory, batch}};
        REQUIRE(difference(faces_of(file, style), as_triangles(mesh)) == "");
        REQUIRE(difference(test::faces_of_pipe(file, style), as_triangles(mesh)) == "");
      }
    }
  }
}

TEST_CASE("corners of an OBJ: alone, with texture, with normal, counted from the end") {
  const std::string vertices = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n";
  for (const char* faces :
       {"f 1 2 3\nf 1 3 4\n", "f 1/1 2/1 3/1\nf 1/4 3/4 4/4",
        "f 1/1/1 2/1/1 3/1/1\nf 1//1 3//2 4//3", "f -4 -3 -2\nf -4 -2 -1", "f 1 2 3 4",
        "f 1// 2// 3//\nf 1/ 3/ 4/", "f +1 +2 +3\nf 1 3 4\n",
        "f 1 \\\n 2 \\\r\n 3\nf 1\\\n 3 4 # 5", "\n\nf\t1  2\t3 \n# f 1 2 3\n  f 1 3 4  "}) {
    CAPTURE(faces);
    CHECK(difference(both_ways(vertices + faces), as_triangles(test::unit_square)) == "");
  }
  // Faces before all vertices, and between them.
  CHECK(difference(both_ways("f 1 2 3 4\n" + vertices), as_triangles(test::unit_square)) == "");
  CHECK(difference(both_ways("v 0 0 0\nv 1 0 0\nv 1 1 0\nf -3 -2 -1\nf 1 3 4\nv 0 1 0"),
                   as_triangles(test::unit_square)) == "");
}

TEST_CASE("names in an OBJ are no vertices and no faces") {
  const std::string file =
      "mtllib f 1 2 3\ng v 9 9 9\no f\nusemtl v\ns 1\nv 0 0 0 1.0\nv 1 0 0 0.5 0.5 0.5\nvn 1 2 "
      "3\nvt 5 5\n"
      "v 1 1 0 1 0.5 0.5 0.5\nv 0 1 0\ng An f Three Other Things\nusemtl f\nf 1 2 3\nl 1 2\np 1\nf "
      "1 3 "
      "4\n";
  CHECK(difference(both_ways(file), as_triangles(test::unit_square)) == "");
}

TEST_CASE("what is passed over in an OBJ may end in a backslash") {
  const std::vector<std::string> vertices{"v 0 0 0", "v 1 0 0", "v 1 1 0", "v 0 1 0"};
  for (const std::string end : {"\n", "\r\n", "\r"}) {
    for (const std::string name :
         {"g D:\\parts\\", "o \\", "s 1 \\", "mtllib a\\b\\", "usemtl \\", "# C:\\", "$ \\",
          "l 1 2 \\", "vn 0 0 1 \\", "vt 0 0\\", "call a\\", "\\"}) {
      CAPTURE(name, end);
      std::string file;
      for (const std::string& vertex : vertices) file += name + end + vertex + end;
      for (const std::string face : {"f 1 2 3", "f 1 3 4"}) file += name + end + face + end;
      for (const std::size_t batch : {1, 4, 8192}) {
        const test::ReadStyle style{
            Format::automatic, Access::once, {test::usual_vertex_memory, batch}};
        CHECK(difference(faces_of(file, style), as_triangles(test::unit_square)) == "");
        CHECK(difference(test::faces_of_pipe(file, style), as_triangles(test::unit_square)) == "");
      }
    }
  }
  // In a comment behind a statement, too.
  CHECK(difference(both_ways("v 0 0 0 # \\\nv 1 0 0 # a \\\nv 1 1 0\nv 0 1 0\nf 1 2 3 4 # \\\n"),
                   as_triangles(test::unit_square)) == "");
  // A statement that is read goes on, over any number of lines and blanks behind the backslash.
  CHECK(difference(
            both_ways("v \\ \n0 0\\\n 0\nv 1 0 0\nv\\\n1 1 0\nv 0 1 0\nf \\\n\\\n1 2 \\\t\n3 4"),
            as_triangles(test::unit_square)) == "");
}

TEST_CASE("an OBJ of lines that all end in a backslash is cut between them") {
  std::string file;
  for (int i = 0; i < 200'000; ++i) file += "# a comment \\\n";
  file += "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3 4\n";
  CHECK(difference(faces_of(file, {Format::obj}), as_triangles(test::unit_square)) == "");
}

TEST_CASE("colours of an OBJ: three or four numbers behind the position") {
  const auto carried = [](const std::string& numbers) {
    std::string file;
    for (const char* vertex : {"v 0 0 0", "v 1 0 0", "v 1 1 0"}) file += vertex + numbers + "\n";
    return test::carried_by(std::make_unique<test::MemorySource>(file + "f 1 2 3\n"));
  };
  CHECK(carried(" 1 0.5 0.25").attributes ==
        std::vector<std::string>{"red (float)", "green (float)", "blue (float)"});
  const test::Carried with_alpha = carried(" 1 0.5 0.25 0.75");
  CHECK(with_alpha.attributes ==
        std::vector<std::string>{"red (float)", "green (float)", "blue (float)", "alpha (float)"});
  CHECK(with_alpha.numbers ==
        std::vector<double>{1, 1, 1, 0.5, 0.5, 0.5, 0.25, 0.25, 0.25, 0.75, 0.75, 0.75});
}

TEST_CASE("colours in comments of an OBJ are named as not carried") {
  test::TestJob test;
  const auto reader =
      open_reader(test.job,
                  std::make_unique<test::MemorySource>(
                      "v 0 0 0\nv 1 0 0\nv 1 1 0\n#MRGB ffffffffff00ff00\nf 1 2 3\n"),
                  Format::automatic, Access::once, {test::usual_vertex_memory, 512});
  CHECK(reader->facts().offer.unread == std::vector<std::string>{"colours in #MRGB comments"});
}

TEST_CASE("faces of an OBJ that are none are told apart") {
  const std::string vertices = "v 0 0 0\nv 1 0 0\nv 1 1 0\n";
  const auto status = [&](const std::string& face) {
    const std::vector<test::SeenFace> faces = both_ways(vertices + face);
    REQUIRE(faces.size() == 1);
    return faces[0].status;
  };
  CHECK(status("f 1 2 3") == FaceStatus::good);
  for (const char* face : {"f", "f 1", "f 2 3"}) CHECK(status(face) == FaceStatus::degenerate);
  for (const char* face :
       {"f 0 1 2", "f 1 2 4", "f -4 1 2", "f 1 2 99999999999999999999", "f 4294967297 2 3",
        "f 1 2 4294967296", "f -4294967299 2 3", "f 1 2 -9223372036854775808"}) {
    CAPTURE(face);
    CHECK(status(face) == FaceStatus::out_of_range);
  }
}

TEST_CASE("an OBJ is one of floats, unless its digits say more") {
  const auto read = [](const std::string& x) {
    test::TestJob test;
    const auto reader = open_reader(
        test.job,
        std::make_unique<test::MemorySource>("v 0.1 1e3 2\nv " + x + " 0 0\nv 1 0 0\nf 1 2 3\n"),
        Format::automatic, Access::once, {test::usual_vertex_memory, 512});
    const std::vector<test::SeenFace> faces = test::read_faces(test.job, *reader);
    CHECK(test::difference(test::read_positions(test.job, *reader),
                           {faces[0].corner.begin(), faces[0].corner.end()}) == "");
    return std::pair(reader->facts().double_positions, faces[0].corner);
  };
  const auto [single_is_double, single] = read("123.456001");
  CHECK_FALSE(single_is_double);
  CHECK(single[0][0] == double{0.1F});
  CHECK(single[1][0] == double{123.456001F});
  const auto [double_is_double, wide] = read("5412000.125001");
  CHECK(double_is_double);
  CHECK(wide[0][0] == 0.1);
  CHECK(wide[1][0] == 5412000.125001);
}

}  // namespace winnow
