// STL files cut short: an error, or the faces before the cut.
#include "support/job.hpp"
#include "support/reading.hpp"
#include "support/stl_file.hpp"

#include <catch2/catch.hpp>

namespace winnow {

namespace {

// What comes must be the first faces, all that are whole in the cut file.
void check_cut(const std::string& cut, const std::vector<test::SeenFace>& faces,
               std::size_t whole) {
  for (const bool pipe : {false, true}) {
    CAPTURE(cut.size(), pipe);
    try {
      const std::vector<test::SeenFace> seen =
          pipe ? test::faces_of_pipe(cut) : test::faces_of(cut);
      REQUIRE(test::difference(
                  seen, {faces.begin(), faces.begin() + static_cast<std::ptrdiff_t>(whole)}) == "");
    } catch (const Error& error) {
      REQUIRE(error.kind() == ErrorKind::bad_input);
    }
  }
}

void check_binary_cuts(std::size_t count, std::size_t step, const std::string& header) {
  test::Random random(290);
  const std::vector<test::Triangle> faces = test::random_triangles(random, count);
  const std::string file = test::binary_stl(faces, {header, -1, ""});
  for (std::size_t length = 0; length < file.size(); length += step) {
    check_cut(file.substr(0, length), test::as_seen(faces), length < 84 ? 0 : (length - 84) / 50);
  }
}

void check_ascii_cuts(std::size_t count, std::size_t step) {
  test::Random random(291);
  const std::vector<test::Triangle> faces = test::random_triangles(random, count);
  const std::string file = test::ascii_stl(faces);
  for (std::size_t length = 0; length < file.size(); length += step) {
    const std::string cut = file.substr(0, length);
    std::size_t whole = 0;
    for (std::size_t at = 0; (at = cut.find("endfacet", at)) != std::string::npos; ++at) ++whole;
    check_cut(cut, test::as_seen(faces), whole);
  }
}

}  // namespace

TEST_CASE("a binary STL cut at every 512 bytes is an error or a shorter STL") {
  check_binary_cuts(1500, 512, "plain");
  check_binary_cuts(1500, 512, "solid all the same");
}

TEST_CASE("a small binary STL cut at every byte is an error or a shorter STL") {
  check_binary_cuts(4, 1, "plain");
  check_binary_cuts(30, 1, "solid all the same");
}

TEST_CASE("an ASCII STL cut at every 512 bytes is an error or a shorter STL") {
  check_ascii_cuts(600, 512);
}

TEST_CASE("a small ASCII STL cut at every byte is an error or a shorter STL") {
  check_ascii_cuts(8, 1);
}

TEST_CASE("an STL cut inside its first face is refused, not taken for one without faces") {
  test::Random random(292);
  const std::string file = test::binary_stl(test::random_triangles(random, 10));
  for (std::size_t length = 84; length < 134; ++length) {
    CHECK(test::error_of([&] { test::faces_of(file.substr(0, length)); }).kind() ==
          ErrorKind::bad_input);
  }
}

}  // namespace winnow
