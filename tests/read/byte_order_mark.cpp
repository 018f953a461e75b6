// A UTF-8 byte order mark before a text changes nothing.
#include "support/ply_file.hpp"
#include "support/reading.hpp"
#include "support/stl_file.hpp"
#include "support/text_meshes.hpp"

#include <catch2/catch.hpp>

namespace winnow {

namespace {

struct MarkedFile {
  Format format;
  std::string text;
};

std::vector<MarkedFile> text_files() {
  test::Random random(450);
  const test::Polygons mesh = test::as_floats(test::random_polygons(random, 40, 60, 4));
  return {{Format::obj, obj_file(mesh, {})},
          {Format::off, off_file(mesh, {}, "COFF")},
          {Format::m, m_file(mesh, {})},
          {Format::ply, ply_file(mesh, test::PlyStyle{.form = PlyForm::ascii})},
          {Format::ply, ply_file(mesh, test::PlyStyle{.form = PlyForm::little_endian})},
          {Format::stl, test::ascii_stl(test::random_triangles(random, 40))}};
}

}  // namespace

TEST_CASE("a byte order mark before a text is passed over") {
  for (const MarkedFile& file : text_files()) {
    const std::string marked = "\xef\xbb\xbf" + file.text;
    for (const Format format : {Format::automatic, file.format}) {
      for (const Access access : {Access::once, Access::repeatedly}) {
        CAPTURE(file.text.substr(0, 20), static_cast<int>(format), static_cast<int>(access));
        const test::ReadStyle style{format, access};
        const std::vector<test::SeenFace> right = test::faces_of(file.text, style);
        REQUIRE(right.size() >= 40);
        CHECK(test::difference(test::faces_of(marked, style), right) == "");
        CHECK(test::difference(test::faces_of_pipe(marked, style), right) == "");
      }
    }
  }
}

TEST_CASE("a byte order mark does not move the line that an error names") {
  for (const std::string text : {"v 0 0 0\nv 1 x 0\n", "OFF\n1 x 0\n", "ply\nformat wrong\n"}) {
    const Error error = test::error_of([&] { test::faces_of("\xef\xbb\xbf" + text); });
    CAPTURE(error.what());
    CHECK(std::string(error.what()).find("line 2") != std::string::npos);
  }
}

}  // namespace winnow
