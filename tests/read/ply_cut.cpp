// PLY files cut short.
#include "support/job.hpp"
#include "support/ply_file.hpp"
#include "support/reading.hpp"

#include <catch2/catch.hpp>

namespace winnow {

namespace {

// The last word of an ASCII file may be cut to a shorter number: nothing can tell.
bool only_last_word_cut(const std::string& file, std::size_t length) {
  return file.find_first_of(" \n", length) >= file.size() - 1;
}

void check_cuts(const std::string& file, bool ascii, std::size_t step) {
  for (std::size_t length = step; length < file.size(); length += step) {
    CAPTURE(length, file.size());
    for (const bool pipe : {false, true}) {
      const std::string cut = file.substr(0, length);
      if (ascii && only_last_word_cut(file, length)) continue;
      const Error error =
          test::error_of([&] { pipe ? test::faces_of_pipe(cut) : test::faces_of(cut); });
      REQUIRE(error.kind() == ErrorKind::bad_input);
    }
  }
}

}  // namespace

TEST_CASE("a PLY cut at every 512 bytes is an error", "[slow]") {
  test::Random random(250);
  const test::Polygons triangles = test::random_polygons(random, 3000, 6000, 3);
  const test::Polygons polygons = test::random_polygons(random, 1500, 3000, 6);
  for (const test::Polygons* mesh : {&triangles, &polygons}) {
    for (int form = 0; form < 3; ++form) {
      test::PlyStyle style;
      style.form = static_cast<PlyForm>(form);
      CAPTURE(form);
      check_cuts(ply_file(*mesh, style), form == 0, 512);
      style.faces_first = true;
      check_cuts(ply_file(*mesh, style), form == 0, 512);
    }
  }
}

TEST_CASE("a small PLY cut at every byte is an error") {
  test::Random random(251);
  const test::Polygons mesh = test::random_polygons(random, 5, 4, 4);
  for (int form = 0; form < 3; ++form) {
    for (const char* end : {"\n", "\r\n"}) {
      test::PlyStyle style;
      style.form = static_cast<PlyForm>(form);
      style.line_end = end;
      CAPTURE(form, end);
      check_cuts(ply_file(mesh, style), form == 0, 1);
    }
  }
}

TEST_CASE("an element behind the faces may be cut: nobody asked for it") {
  const std::string file =
      "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float "
      "z\nelement face 1\n"
      "property list uchar int vertex_indices\nelement edge 5\nproperty list int int "
      "a\nend_header\n0 0 0\n1 "
      "0 0\n0 1 0\n3 0 1 2\n2 7 7\n";
  CHECK(test::faces_of_pipe(file).size() == 1);
}

}  // namespace winnow
