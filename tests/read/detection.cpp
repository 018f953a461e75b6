// Which format a text is in: by its first statement, else by later ones, else by its name.
#include "support/job.hpp"
#include "support/notes.hpp"
#include "support/reading.hpp"
#include "support/sources.hpp"
#include "support/stl_file.hpp"
#include "support/text_meshes.hpp"

#include <catch2/catch.hpp>

namespace winnow {

namespace {

std::string format_of_file(const std::string& content, const std::string& name = "test") {
  std::string format;
  for (const auto kind : {test::MemorySource::Kind::file, test::MemorySource::Kind::pipe}) {
    test::TestJob test;
    const auto reader =
        open_reader(test.job, std::make_unique<test::MemorySource>(content, kind, name),
                    Format::automatic, Access::once, {test::usual_vertex_memory, 512});
    CHECK(test::read_faces(test.job, *reader).size() == 2);
    CHECK((format.empty() || format == reader->facts().format));
    format = reader->facts().format;
  }
  return format;
}

const std::string obj = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3\nf 1 3 4\n";
const std::string off = "OFF\n4 2 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n3 0 1 2\n3 0 2 3\n";
const std::string m =
    "Vertex 1 0 0 0\nVertex 2 1 0 0\nVertex 3 1 1 0\nVertex 4 0 1 0\nFace 1 1 2 3\nFace 2 1 3 4\n";
const std::string ply =
    "ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty float y\nproperty float "
    "z\n"
    "element face 2\nproperty list uchar int vertex_indices\nend_header\n0 0 0\n1 0 0\n1 1 0\n0 1 "
    "0\n3 0 1 "
    "2\n"
    "3 0 2 3\n";

std::string stl() {
  test::Random random(460);
  return test::ascii_stl(test::random_triangles(random, 2));
}

}  // namespace

TEST_CASE("a text is known by its statements, whatever stands before them") {
  for (const std::string before : {"", "\n \n\t\n", "# a comment\n", "\n# v f OFF ply solid\n\n"}) {
    CAPTURE(before);
    CHECK(format_of_file(before + obj) == "OBJ");
    CHECK(format_of_file(before + off) == "OFF");
    CHECK(format_of_file(before + m) == ".m");
    CHECK(format_of_file(before + stl()) == "STL ASCII");
    if (before.find('#') == std::string::npos) CHECK(format_of_file(before + ply) == "PLY ASCII");
  }
  for (const std::string before :
       {"$ made by a program\n", "; v 1\n", "Costly reader,\n\nhere it is:\n", "vertices follow\n",
        "// a comment\n", "!\n\"\n"}) {
    CAPTURE(before);
    CHECK(format_of_file(before + obj) == "OBJ");
    CHECK(format_of_file(before + m) == ".m");
    CHECK(format_of_file(before + stl()) == "STL ASCII");
  }
}

TEST_CASE("keywords of other spelling are the same keywords") {
  for (const char* keyword : {"off", "OFF\t", "off\r", "off # so", "\noff"}) {
    CAPTURE(keyword);
    std::string file = off;
    file.replace(0, 3, keyword);
    CHECK(format_of_file(file) == "OFF");
  }
  for (const char* first : {"ply ", "ply\t", " ply", "ply  \r", "\nply"}) {
    CAPTURE(first);
    std::string file = ply;
    file.replace(0, 3, first);
    CHECK(format_of_file(file) == "PLY ASCII");
  }
}

TEST_CASE("between equal candidates the name of the file decides") {
  // Behind a first line of neither, vertices and faces of both.
  const std::string both = "$ a text\n" + obj + m;
  CHECK(format_of_file(both, "mesh.obj") == "OBJ");
  CHECK(format_of_file(both, "mesh.M") == ".m");
  CHECK(format_of_file(both, "mesh.obj.gz") == "OBJ");
  // A better candidate is not outvoted.
  CHECK(format_of_file(obj, "mesh.m") == "OBJ");
  CHECK(format_of_file(off, "mesh.obj") == "OFF");
}

TEST_CASE("a decimal comma is named as what is wrong") {
  const std::string point = "the decimal sign must be a point";
  for (const std::string file :
       {"v 1,5 2,0 3\nv 1 0 0\nv 0 1 0\nf 1 2 3\n", "v 1 0 0\nv 1 0,25 0\nv 0 1 0\nf 1 2 3\n",
        "OFF\n3 1 0\n0 0 -1,5e3\n1 0 0\n0 1 0\n3 0 1 2\n", "Vertex 1 0 0 0,5\nVertex 2 1 0 0\n",
        "solid a\nfacet normal 0 0 1\nouter loop\nvertex 1,5 0 0\n",
        "ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\nproperty float y\nproperty "
        "float z\n"
        "element face 1\nproperty list uchar int vertex_indices\nend_header\n0,5 0 0\n3 0 0 0\n"}) {
    CAPTURE(file);
    CHECK(std::string(test::error_of([&] { test::faces_of(file); }).what()).find(point) !=
          std::string::npos);
  }
  CHECK(std::string(
            test::error_of([&] { test::faces_of("v 1,2,3\nv 1,2x 0 0\n", {Format::obj}); }).what())
            .find(point) == std::string::npos);
}

TEST_CASE("an OFF without its keyword is read where its name or the caller says that it is one") {
  const std::string bare = off.substr(4);
  for (const std::string before : {"", "# a comment\n\n", "\xEF\xBB\xBF"}) {
    CAPTURE(before);
    CHECK(format_of_file(before + bare, "mesh.off") == "OFF");
    CHECK(format_of_file(before + bare, "MESH.OFF.gz") == "OFF");
    CHECK(format_of_file(before + "4 2" + bare.substr(5), "mesh.off") == "OFF");
    for (const std::string name : {"test", "mesh.obj", "mesh.stl"})
      CHECK(test::error_of([&] { format_of_file(before + bare, name); }).kind() ==
            ErrorKind::bad_input);
  }
  // What is not counts alone is none, and the name does not outweigh the content.
  CHECK(test::error_of([] { format_of_file("4 2 0 7\n" + off.substr(10), "mesh.off"); }).kind() ==
        ErrorKind::bad_input);
  CHECK(format_of_file("4 2 0\n" + obj, "mesh.off") == "OBJ");
  for (const bool keyword : {false, true}) {
    test::TestJob test;
    const auto reader =
        open_reader(test.job, std::make_unique<test::MemorySource>(keyword ? off : bare),
                    Format::off, Access::once, {test::usual_vertex_memory, 512});
    CHECK(test::read_faces(test.job, *reader).size() == 2);
    CHECK(test.job.notes.size() == (keyword ? 0 : 1));
    CHECK(test::has_note(test.job.notes, "lacks the keyword 'OFF'") == !keyword);
  }
}

}  // namespace winnow
