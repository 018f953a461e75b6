// Binary STL, honest and not.
#include "support/job.hpp"
#include "support/reading.hpp"
#include "support/sources.hpp"
#include "support/stl_file.hpp"

#include <catch2/catch.hpp>

namespace winnow {

using test::difference;

namespace {

struct Read {
  std::vector<test::SeenFace> faces;
  std::string format;
  std::vector<std::string> notes;
};

Read read(const std::string& file, test::MemorySource::Kind kind,
          const std::string& name = "test.stl", Format format = Format::automatic) {
  test::TestJob test;
  const auto reader = open_reader(test.job, std::make_unique<test::MemorySource>(file, kind, name),
                                  format, Access::once, {test::usual_vertex_memory, 256});
  Read out;
  out.format = reader->facts().format;
  out.faces = test::read_faces(test.job, *reader);
  out.notes = test.job.notes;
  CHECK(reader->bytes() == file.size());
  return out;
}

constexpr auto both_kinds = {test::MemorySource::Kind::file, test::MemorySource::Kind::pipe};

}  // namespace

TEST_CASE("a binary STL is read as it was written") {
  test::Random random(270);
  for (const std::size_t count : {1, 2, 255, 256, 257, 5000}) {
    const std::vector<test::Triangle> faces = test::random_triangles(random, count);
    for (const auto kind : both_kinds) {
      const Read got = read(test::binary_stl(faces), kind);
      CAPTURE(count, static_cast<int>(kind));
      CHECK(difference(got.faces, test::as_seen(faces)) == "");
      CHECK(got.format == "STL binary");
      CHECK(got.notes.empty());
    }
  }
}

TEST_CASE("a binary STL may begin with the word solid") {
  test::Random random(271);
  for (const std::string header : {"solid", "solid exported by a program", "SOLID facet normal",
                                   "  solid x", "solid\nfacet normal 0 0 1\nouter loop\n"}) {
    for (const std::size_t count : {1, 3, 1000}) {
      const std::vector<test::Triangle> faces = test::random_triangles(random, count);
      for (const auto kind : both_kinds) {
        for (const std::int64_t declared : {std::int64_t{-1}, std::int64_t{0}}) {
          if (declared == 0 && kind == test::MemorySource::Kind::file && count == 0) continue;
          CAPTURE(header, count, static_cast<int>(kind), declared);
          const Read got = read(test::binary_stl(faces, {header, declared, ""}), kind);
          CHECK(got.format == "STL binary");
          CHECK(difference(got.faces, test::as_seen(faces)) == "");
        }
      }
    }
  }
}

TEST_CASE("a wrong count is settled by the size, and told") {
  test::Random random(272);
  const std::vector<test::Triangle> faces = test::random_triangles(random, 1000);
  for (const std::int64_t count : {std::int64_t{0}, std::int64_t{1}, std::int64_t{999},
                                   std::int64_t{1001}, std::int64_t{4294967295}}) {
    for (const auto kind : both_kinds) {
      const Read got = read(test::binary_stl(faces, {"x", count, ""}), kind);
      CAPTURE(count, static_cast<int>(kind));
      CHECK(difference(got.faces, test::as_seen(faces)) == "");
      REQUIRE(got.notes.size() == 1);
      CHECK(got.notes[0].find("1,000") != std::string::npos);
    }
  }
}

TEST_CASE("what is left behind the last face is told and left out") {
  test::Random random(273);
  const std::vector<test::Triangle> faces = test::random_triangles(random, 1000);
  for (const std::size_t trailing : {1, 49}) {
    for (const auto kind : both_kinds) {
      const Read got = read(test::binary_stl(faces, {"x", -1, std::string(trailing, 'z')}), kind);
      CAPTURE(trailing, static_cast<int>(kind));
      CHECK(difference(got.faces, test::as_seen(faces)) == "");
      REQUIRE(got.notes.size() == 1);
      CHECK(got.notes[0].find(std::to_string(trailing)) != std::string::npos);
    }
  }
}

TEST_CASE("bytes that are no mesh are not taken for a binary STL") {
  test::Random random(275);
  for (int i = 0; i < 200; ++i) {
    const std::string noise = random.bytes(200 + random.below(5000));
    for (const auto kind : both_kinds)
      CHECK(test::error_of([&] { read(noise, kind); }).kind() == ErrorKind::bad_input);
  }
  // A count that is wrong makes no picture of a mesh.
  const std::vector<test::Triangle> faces = test::random_triangles(random, 300);
  std::string file = test::binary_stl(faces);
  file[82] = 1;
  for (const auto kind : both_kinds)
    CHECK(difference(read(file, kind).faces, test::as_seen(faces)) == "");
}

TEST_CASE("what no name or option calls an STL is one only where its count fits") {
  test::Random random(276);
  const std::vector<test::Triangle> faces = test::random_triangles(random, 1000);
  for (const std::int64_t count : {0, 1, 999, 1001, 65536}) {
    const std::string file = test::binary_stl(faces, {"x", count, ""});
    for (const auto kind : both_kinds) {
      CAPTURE(count, static_cast<int>(kind));
      const Error error = test::error_of([&] { read(file, kind, "mesh.bin"); });
      CHECK(error.kind() == ErrorKind::bad_input);
      CHECK(std::string(error.what()).find("`from` stl") != std::string::npos);
      CHECK(difference(read(file, kind, "mesh.bin", Format::stl).faces, test::as_seen(faces)) ==
            "");
      for (const char* name : {"A.STL", "a.stl.gz", "a.stl.zst"})
        CHECK(difference(read(file, kind, name).faces, test::as_seen(faces)) == "");
    }
  }
  for (const auto kind : both_kinds)
    CHECK(read(test::binary_stl(faces), kind, "mesh.bin").faces.size() == 1000);
}

TEST_CASE("colours of an STL's faces are named as not carried, once") {
  test::Random random(277);
  const std::vector<test::Triangle> faces = test::random_triangles(random, 700);
  const std::vector<std::string> note{"not carried: colours of faces"};
  for (const auto kind : both_kinds) {
    CHECK(read(test::binary_stl(faces, {.attribute = 0x8000}), kind).notes == note);
    CHECK(read(test::binary_stl(faces, {"COLOR=\x10\x20\x30\xff", -1, "", 0}), kind).notes == note);
    CHECK(read(test::binary_stl(faces, {.attribute = 0x7fff}), kind).notes.empty());
    // Of one face in the middle, too.
    std::string file = test::binary_stl(faces);
    file[84 + 50 * 333 + 49] = '\x80';
    CHECK(read(file, kind).notes == note);
  }
}

TEST_CASE("an STL of no faces is one of no faces") {
  for (const auto kind : both_kinds) CHECK(read(test::binary_stl({}), kind).faces.empty());
}

TEST_CASE("faces and positions can be read again and again from a file") {
  test::Random random(274);
  const std::vector<test::Triangle> faces = test::random_triangles(random, 3000);
  std::vector<test::Point> corners;
  for (const test::Triangle& face : faces) corners.insert(corners.end(), face.begin(), face.end());
  for (const std::string& file : {test::binary_stl(faces), test::ascii_stl(faces)}) {
    test::TestJob test;
    const auto reader =
        open_reader(test.job, std::make_unique<test::MemorySource>(file), Format::automatic,
                    Access::repeatedly, {test::usual_vertex_memory, 256});
    for (int pass = 0; pass < 3; ++pass) {
      CHECK(reader->first_finite_position() == faces[0][0]);
      CHECK(difference(test::read_positions(test.job, *reader), corners) == "");
      CHECK(difference(test::read_faces(test.job, *reader), test::as_seen(faces)) == "");
    }
  }
}

}  // namespace winnow
