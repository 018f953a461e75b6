// A concave polygon has the area that it shows, in every format and wherever its vertices stand.
#include "support/ply_file.hpp"
#include "support/reading.hpp"
#include "support/sources.hpp"
#include "support/text_meshes.hpp"

#include <catch2/catch.hpp>

namespace winnow::test {

namespace {

// Two forms of the letter L, each of area 5, the second begun at another corner, and a bow tie.
const Polygons letters{
    {{0, 0, 0},
     {3, 0, 0},
     {3, 1, 0},
     {1, 1, 0},
     {1, 3, 0},
     {0, 3, 0},
     {0, 0, 9},
     {2, 2, 9},
     {2, 0, 9},
     {0, 1, 9}},
    {{0, 1, 2, 3, 4, 5}, {0, 1, 3}, {4, 5, 0, 1, 2, 3}, {1, 2, 3}, {6, 7, 8, 9}}};

double area_of_ls(const std::vector<SeenFace>& faces) {
  double sum = 0;
  for (const SeenFace& face : faces) {
    if (face.corner[0][2] == 0) sum += length(doubled_area(face.corner)) / 2;
  }
  return sum;
}

void check_letters(const std::string& file) {
  for (const std::size_t batch : {8, 8192}) {
    TestJob test;
    const ReadStyle style{Format::automatic, Access::once, {usual_vertex_memory, batch}};
    const auto faces = faces_of(test.job, std::make_unique<MemorySource>(file), style);
    CHECK(faces.size() == 12);
    // Both letters, and the two triangles.
    CHECK(area_of_ls(faces) == Approx(2 * 5 + 1.5 + 1));
    REQUIRE(test.job.notes.size() == 1);
    CHECK(test.job.notes[0].starts_with("1 polygon of "));
    CHECK(difference(faces_of_pipe(file, style), faces) == "");
  }
}

}  // namespace

TEST_CASE("a concave facet of an STL keeps its area") {
  std::string file = "solid s\nfacet normal 0 0 1\nouter loop\n";
  for (const char* corner : {"1 3 0", "0 3 0", "0 0 0", "3 0 0", "3 1 0", "1 1 0"})
    file += std::string("vertex ") + corner + "\n";
  file += "endloop\nendfacet\nendsolid s\n";
  const auto faces = faces_of(file);
  CHECK(faces.size() == 4);
  CHECK(area_of_ls(faces) == Approx(5));
}

TEST_CASE("concave polygons keep their area in every format") {
  check_letters(obj_file(letters, {}));
  check_letters(off_file(letters, {}));
  for (const PlyForm form : {PlyForm::ascii, PlyForm::little_endian, PlyForm::big_endian}) {
    for (const bool faces_first : {false, true}) {
      PlyStyle style;
      style.form = form;
      style.faces_first = faces_first;
      check_letters(ply_file(letters, style));
    }
  }
}

}  // namespace winnow::test
