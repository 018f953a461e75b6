// What is written as STL is read back.
#include "support/reading.hpp"
#include "support/sources.hpp"
#include "support/surfaces.hpp"
#include "write/formats.hpp"

#include <cstring>

#include <catch2/catch.hpp>

namespace winnow {

using namespace test;

namespace {

std::string encoded(const std::vector<Corners>& corners, Random& random, bool ascii = false) {
  const auto encoder = stl_output.make({.ascii = ascii});
  const MeshShape shape{3 * corners.size(), corners.size(), true, true, "made for a test"};
  std::string text = encoder->header(shape);
  std::vector<std::byte> bytes;
  const std::vector<MeshVertex> vertices(10);
  encoder->vertices(shape, 0, vertices, bytes);
  REQUIRE(bytes.empty());  // the format has none
  std::size_t at = 0;
  for (const std::size_t part : random.parts(corners.size(), 100)) {
    encoder->faces(shape, at, std::vector<MeshFace>(part), std::span(corners).subspan(at, part),
                   bytes);
    at += part;
  }
  return text + text_of(bytes) + encoder->footer(shape);
}

}  // namespace

TEST_CASE("a written STL is read back as it was, to floats") {
  Random random(610);
  for (const std::size_t count : {0, 1, 3, 1000}) {
    const std::vector<Triangle> faces = placed(soup(random, count, 0.3), 100, {5e6, -3, 0.1});
    const std::string file = encoded(faces, random);
    CAPTURE(count);
    CHECK(file == encoded(faces, random));
    CHECK(file.size() == 84 + 50 * count);
    if (count == 0) continue;
    TestJob here;
    const auto reader = open_reader(here.job, std::make_unique<MemorySource>(file),
                                    Format::automatic, Access::once, {usual_vertex_memory, 100});
    CHECK(reader->facts().format == "STL binary");
    std::vector<SeenFace> right;
    for (const Triangle& face : as_floats(faces)) right.push_back({FaceStatus::good, face});
    CHECK(difference(read_faces(here.job, *reader), right) == "");
    CHECK(here.job.notes.empty());  // the count is right
  }
}

TEST_CASE("an STL written as text is read back as it was, to floats") {
  Random random(612);
  for (const std::size_t count : {1, 3, 300}) {
    const std::vector<Triangle> faces = placed(soup(random, count, 0.3), 100, {5e6, -3, 0.1});
    const std::string file = encoded(faces, random, true);
    TestJob here;
    const auto reader = open_reader(here.job, std::make_unique<MemorySource>(file),
                                    Format::automatic, Access::once, {usual_vertex_memory, 100});
    CHECK(reader->facts().format == "STL ASCII");
    std::vector<SeenFace> right;
    for (const Triangle& face : as_floats(faces)) right.push_back({FaceStatus::good, face});
    CHECK(difference(read_faces(here.job, *reader), right) == "");
    CHECK(here.job.notes.empty());
  }
  const Triangle face{Point{0, 0, 0}, Point{1, 0, 0}, Point{0, 0.1, 0}};
  CHECK(encoded({face}, random, true) ==
        "solid made for a test\nfacet normal 0 0 1\n outer loop\n  vertex 0 0 0\n  vertex 1 0 0\n"
        "  vertex 0 0.1 0\n endloop\nendfacet\nendsolid made for a test\n");
}

TEST_CASE("the normal of a facet is its own, of one unit, or nothing") {
  Random random(611);
  std::vector<Triangle> faces = soup(random, 500, 0.3);
  faces.push_back({Point{0, 0, 0}, Point{1, 1, 1}, Point{2, 2, 2}});
  const std::string file = encoded(faces, random);
  for (std::size_t i = 0; i < faces.size(); ++i) {
    std::array<float, 3> n{};
    std::memcpy(n.data(), file.data() + 84 + 50 * i, sizeof n);
    const Point area = area_vector(faces[i]);
    const Point normal{n[0], n[1], n[2]};
    if (i + 1 == faces.size()) {
      CHECK(normal == Point{0, 0, 0});
    } else {
      CHECK(length(normal - (1 / length(area)) * area) < 1e-6);
    }
    CHECK(std::memcmp(file.data() + 84 + 50 * i + 48, "\0\0", 2) == 0);
  }
}

TEST_CASE("the header is no text that begins an ASCII file, and counts as far as it can") {
  const auto encoder = stl_output.make({});
  for (const std::string& comment :
       {std::string(), std::string("solid facet"), std::string(500, 'c')}) {
    for (const std::uint64_t faces : {std::uint64_t{0}, std::uint64_t{7}, std::uint64_t{UINT32_MAX},
                                      std::uint64_t{UINT32_MAX} + 1, UINT64_MAX}) {
      const std::string header = encoder->header({0, faces, false, false, comment});
      REQUIRE(header.size() == 84);
      CHECK(header.rfind("solid", 0) == std::string::npos);
      std::uint32_t count = 0;
      std::memcpy(&count, header.data() + 80, 4);
      CHECK(count == std::min<std::uint64_t>(faces, UINT32_MAX));
    }
  }
}

}  // namespace winnow
