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
  refused(
      "solidarity is no word that begins a mesh, and this is longer than a header would be, by "
      "far\n");
  refused("<html><body>404 not found</body></html>\n" + std::string(2000, ' '));
  refused("plywood is not a mesh\n" + std::string(2000, '.'));
  refused(std::string(83, '\0'));
  refused(
      "version https://git-lfs.github.com/spec/v1\noid "
      "sha256:4d7a214614ab2935c943f9e0ff69d22eadbb8f32b1258daaa5e2ca24d17e2393\nsize 12345\n");
}

TEST_CASE("a file that is no mesh is named as what it is, with the way out") {
  struct Foreign {
    std::string bytes, name, way_out;
  };
  const auto utf16 = [](const std::string& text, bool big) {
    std::string wide;
    for (const char c : text) wide += big ? std::string{'\0', c} : std::string{c, '\0'};
    return wide;
  };
  const std::string zeros(2000, '\0');
  const std::string noise = test::Random(302).bytes(2000);
  const std::string obj = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";
  const std::string tar_name = "scan.ply" + std::string(249, '\0');
  for (const Foreign& file : std::vector<Foreign>{
           {"PK\3\4" + noise, "ZIP", "unzip -p"},
           {"PK\3\4" + noise + "3D/3dmodel.model" + noise, "3MF", "export it as"},
           {"7z\xbc\xaf\x27\x1c" + noise, "7z", "7z x -so"},
           {std::string("\xfd\x37zXZ\0", 6) + noise, "xz", "xzcat FILE | winnow simplify -"},
           {"BZh91AY&SY" + noise, "bzip2", "bzcat FILE | winnow"},
           {"\x04\x22\x4d\x18" + noise, "lz4", "lz4cat"},
           {tar_name + "ustar" + zeros, "tar", "tar -xOf"},
           {"Kaydara FBX Binary  \0" + zeros, "FBX", "export it as"},
           {"; FBX 7.3.0 project file\n" + obj, "FBX", "export it as"},
           {"<?xml version=\"1.0\"?>\n<!-- of a program -->\n<COLLADA xmlns=\"\">", "COLLADA",
            "export"},
           {"  <COLLADA xmlns=\"\">", "COLLADA", "export it as"},
           {"LASF" + zeros, "LAS", "surface"},
           {"LASF" + zeros + "laszip encoded" + zeros, "LAZ", "surface"},
           {"ASTM-E57" + zeros, "E57", "surface"},
           {"# vtk DataFile Version 3.0\n" + obj, "VTK", "export it as"},
           {"<?xml version=\"1.0\"?><VTKFile type=\"PolyData\">", "VTK", "export it as"},
           {"<VTKFile type=\"PolyData\">", "VTK", "export it as"},
           {"\x89PNG\r\n\x1a\n" + zeros, "PNG", ""},
           {"\xff\xd8\xff\xe0" + noise, "JPEG", ""},
           {"<!DOCTYPE html>\n<html>" + obj, "HTML", "download"},
           {"\n<html><body>404</body></html>", "HTML", "download"},
           {"version https://git-lfs.github.com/spec/v1\noid sha256:abc\nsize 123\n",
            "Git LFS pointer", "git lfs pull"},
           {"\xff\xfe" + utf16(obj, false), "UTF-16", "iconv -f UTF-16 "},
           {"\xfe\xff" + utf16(obj, true), "UTF-16", "iconv -f UTF-16 "},
           {utf16(obj, false), "UTF-16", "iconv -f UTF-16LE"},
           {utf16(obj, true), "UTF-16", "iconv -f UTF-16BE"},
           {"1.5 2.5 3.5\n1 2 3 255 255 255\n7 8 9\n", "rows of numbers", "point cloud"}}) {
    CAPTURE(file.name, file.bytes.substr(0, 20));
    for (const Format format : {Format::automatic, Format::stl, Format::obj}) {
      if (format != Format::automatic && file.name == "rows of numbers") continue;
      const Error error = test::error_of([&] { test::faces_of(file.bytes, {format}); });
      CAPTURE(error.what());
      CHECK(error.kind() == ErrorKind::bad_input);
      CHECK(std::string(error.what()).find(file.name) != std::string::npos);
      CHECK(std::string(error.what()).find(file.way_out) != std::string::npos);
      CHECK(test::error_of([&] { test::faces_of_pipe(file.bytes, {format}); }).what() ==
            std::string(error.what()));
    }
  }
}

TEST_CASE("a binary STL may begin with the bytes of any format") {
  test::Random random(303);
  const std::vector<test::Triangle> faces = test::random_triangles(random, 10);
  for (const char* header : {"PK\3\4", "<html>", "\x89PNG\r\n\x1a\n", "BZh91AY&SY"})
    CHECK(test::faces_of(test::binary_stl(faces, {header, -1, ""})).size() == 10);
}

TEST_CASE("a format that is asked for is the one that is tried") {
  test::Random random(300);
  const std::vector<test::Triangle> faces = test::random_triangles(random, 10);
  CHECK(test::faces_of(test::binary_stl(faces), {.format = Format::stl}).size() == 10);
  CHECK(test::error_of([&] {
          test::faces_of(test::binary_stl(faces), {.format = Format::ply});
        }).kind() == ErrorKind::bad_input);
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
      bytes = random.one_of<std::string>(
                  {"solid ", "ply\n", "solid facet normal", "ply\nformat ascii 1.0\n"}) +
              bytes;
    for (const bool pipe : {false, true}) {
      try {
        const std::size_t count =
            (pipe ? test::faces_of_pipe(bytes) : test::faces_of(bytes)).size();
        REQUIRE(count <= bytes.size() / 50);
      } catch (const Error& error) {
        REQUIRE(error.kind() == ErrorKind::bad_input);
      }
    }
  }
}

}  // namespace winnow
