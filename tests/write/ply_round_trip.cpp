// What is written as PLY is read back.
#include <winnow/error.hpp>

#include "read/ply/header.hpp"
#include "support/encoding.hpp"
#include "support/reading.hpp"
#include "support/sources.hpp"
#include "write/formats.hpp"

#include <cstring>

#include <catch2/catch.hpp>

namespace winnow {

using namespace test;

TEST_CASE("a written PLY is read back as it was") {
  Random random(600);
  for (const bool ascii : {false, true}) {
    const auto encoder = ply_output.make({.ascii = ascii});
    CHECK_FALSE(encoder->needs_corners());
    for (const auto& [normals, doubles] :
         {std::pair{false, false}, {false, true}, {true, false}, {true, true}}) {
      for (const std::size_t count : {1, 3, 1000}) {
        const EncodedExample mesh =
            example_mesh(random, count, 2 * count, normals, doubles, {}, 5e6);
        const std::string file = encoded(*encoder, mesh, random);
        CAPTURE(ascii, normals, doubles, count);
        CHECK(file == encoded(*encoder, mesh, random));

        TestJob here;
        const auto reader =
            open_reader(here.job, std::make_unique<MemorySource>(file), Format::automatic,
                        Access::once, {usual_vertex_memory, 100});
        CHECK(reader->facts().vertices == count);
        CHECK(reader->facts().faces == 2 * count);
        CHECK(reader->facts().double_positions == doubles);
        CHECK(reader->facts().normals == normals);
        std::vector<Point> positions;
        std::vector<SeenFace> faces;
        for (const MeshVertex& vertex : mesh.vertices) positions.push_back(vertex.position);
        for (const MeshFace& face : mesh.faces) {
          faces.push_back(
              {FaceStatus::good,
               {positions[face.vertex[0]], positions[face.vertex[1]], positions[face.vertex[2]]}});
        }
        CHECK(difference(read_positions(here.job, *reader), positions) == "");
        CHECK(difference(read_faces(here.job, *reader), faces) == "");
      }
    }
  }
}

TEST_CASE("a PLY in text is what its header says, in as few digits as say it") {
  const auto encoder = ply_output.make({.ascii = true});
  const MeshShape shape{1, 1, true, false, ""};
  CHECK(encoder->header(shape).starts_with(
      "ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\n"));
  std::vector<std::byte> bytes;
  const MeshVertex vertex{{0.1F, -2, 1e-20F}, {0, 0, 1}};
  encoder->vertices(shape, 0, {&vertex, 1}, bytes);
  const MeshFace face{{0, 5, 4294967295}};
  encoder->faces(shape, 0, {&face, 1}, {}, bytes);
  CHECK(text_of(bytes) == "0.1 -2 1e-20 0 0 1\n3 0 5 4294967295\n");
}

TEST_CASE("a PLY is what its header says, byte for byte") {
  const auto encoder = ply_output.make({});
  const MeshShape shape{1, 1, true, false, "by winnow"};
  CHECK(encoder->header(shape) ==
        "ply\nformat binary_little_endian 1.0\ncomment by winnow\nelement vertex 1\nproperty float "
        "x\nproperty float y\nproperty float z\n"
        "property float nx\nproperty float ny\nproperty float nz\nelement face 1\nproperty list "
        "uchar int "
        "vertex_indices\nend_header\n");
  std::vector<std::byte> bytes;
  const MeshVertex vertex{{1, -2, 0.5}, {0, 0, 1}};
  encoder->vertices(shape, 0, {&vertex, 1}, bytes);
  const MeshFace face{{0x01020304, 5, 0xfffffffe}};
  encoder->faces(shape, 0, {&face, 1}, {}, bytes);
  const std::array<unsigned char, 37> right{
      0, 0, 0x80, 0x3f, 0,    0, 0, 0xc0, 0, 0, 0, 0x3f, 0, 0, 0,    0,    0,    0,   0,
      0, 0, 0,    0x80, 0x3f, 3, 4, 3,    2, 1, 5, 0,    0, 0, 0xfe, 0xff, 0xff, 0xff};
  REQUIRE(bytes.size() == right.size());
  CHECK(std::memcmp(bytes.data(), right.data(), right.size()) == 0);

  // Without a comment and without normals those lines are not there.
  const std::string plain = encoder->header({1, 1, false, true, ""});
  CHECK(plain.find("comment") == std::string::npos);
  CHECK(plain.find("nx") == std::string::npos);
  CHECK(plain.find("property double z\n") != std::string::npos);
}

TEST_CASE(
    "indices are of a type that counts all vertices, and no more are taken than 32 bits count") {
  const auto encoder = ply_output.make({});
  constexpr std::uint64_t two_to_32 = std::uint64_t{1} << 32;
  for (const auto& [vertices, type] :
       std::vector<std::pair<std::uint64_t, std::string>>{{0, "int"},
                                                          {1000, "int"},
                                                          {two_to_32 / 2, "int"},
                                                          {two_to_32 / 2 + 1, "uint"},
                                                          {two_to_32 - 1, "uint"},
                                                          {two_to_32, "uint"}}) {
    const std::string header = encoder->header({vertices, 5'000'000'000, false, false, ""});
    CAPTURE(vertices);
    CHECK(header.find("list uchar " + type + " vertex_indices\n") != std::string::npos);
    CHECK(header.find("element vertex " + std::to_string(vertices) + "\n") != std::string::npos);
    CHECK(header.find("element face 5000000000\n") != std::string::npos);
  }
  for (const std::uint64_t vertices : {two_to_32 + 1, UINT64_MAX}) {
    CHECK(error_of([&] {
            (void)encoder->header({vertices, 1, false, false, ""});
          }).kind() == ErrorKind::usage);
  }
}

TEST_CASE("a header can be read by the reader up to the most vertices there can be") {
  const auto encoder = ply_output.make({});
  for (const std::uint64_t vertices : {std::uint64_t{0}, std::uint64_t{4'294'967'295}}) {
    MemorySource source(encoder->header({vertices, UINT32_MAX, true, true, "x"}));
    const PlyHeader header = read_ply_header(source);
    CHECK(header.find("vertex")->count == vertices);
    CHECK(header.find("vertex")->smallest_size() == 36);
    CHECK(header.find("face")->smallest_size() == 1);
  }
}

}  // namespace winnow
