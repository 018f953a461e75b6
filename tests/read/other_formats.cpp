// What is no mesh that can be read is named as what it is.
#include "support/job.hpp"
#include "support/reading.hpp"
#include "support/sources.hpp"
#include "support/stl_file.hpp"

#include <catch2/catch.hpp>

namespace winnow {

TEST_CASE("other formats are refused by name") {
  const auto refused = [](const std::string& file) {
    const Error error = test::error_of([&] { test::faces_of(file); });
    CHECK(error.kind() == ErrorKind::bad_input);
    const Error piped = test::error_of([&] { test::faces_of_pipe(file); });
    CHECK(piped.kind() == ErrorKind::bad_input);
    return std::string(error.what());
  };
  CHECK(refused("").find("empty") != std::string::npos);
  refused("x");
  refused("v is no vertex here, and f no face\n");
  refused("g\no thing\ns 1\n");
  refused("# nothing but a comment\n");
  refused("off we go\n");
  refused("Vertex\n");
  refused("solidarity is no word that begins a mesh, and this is longer than a header would be, by far\n");
  refused("<html><body>404 not found</body></html>\n" + std::string(2000, ' '));
  refused("plywood is not a mesh\n" + std::string(2000, '.'));
  refused(std::string(83, '\0'));
  refused(
      "version https://git-lfs.github.com/spec/v1\noid "
      "sha256:4d7a214614ab2935c943f9e0ff69d22eadbb8f32b1258daaa5e2ca24d17e2393\nsize 12345\n");
}

TEST_CASE("a format that is asked for is the one that is tried") {
  test::Random random(300);
  const std::vector<test::Triangle> faces = test::random_triangles(random, 10);
  CHECK(test::faces_of(test::binary_stl(faces), {.format = Format::stl}).size() == 10);
  CHECK(test::error_of([&] { test::faces_of(test::binary_stl(faces), {.format = Format::ply}); }).kind() ==
        ErrorKind::bad_input);
  // A binary STL whose header is that of a PLY.
  const std::string odd = test::binary_stl(faces, {"ply\nformat binary", -1, ""});
  CHECK(test::faces_of(odd, {.format = Format::stl}).size() == 10);
}

TEST_CASE("random bytes are refused or read as a handful of faces, nothing worse") {
  test::Random random(301);
  for (int round = 0; round < 500; ++round) {
    std::string bytes(random.below(3000), '\0');
    for (char& c : bytes) c = static_cast<char>(random.bits() >> 56);
    if (random.chance(0.3))
      bytes =
          random.one_of<std::string>({"solid ", "ply\n", "solid facet normal", "ply\nformat ascii 1.0\n"}) +
          bytes;
    for (const bool pipe : {false, true}) {
      try {
        const std::size_t count = (pipe ? test::faces_of_pipe(bytes) : test::faces_of(bytes)).size();
        REQUIRE(count <= bytes.size() / 50);
      } catch (const Error& error) {
        REQUIRE(error.kind() == ErrorKind::bad_input);
      }
    }
  }
}

}  // namespace winnow
