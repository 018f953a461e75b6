// The name's ending chooses the format where nothing else does, and what a format lacks is refused.
#include <winnow/error.hpp>

#include "support/reading.hpp"
#include "write/formats.hpp"

#include <catch2/catch.hpp>

namespace winnow {

using namespace test;

namespace {

// By how its header begins.
std::string format_of(Format format, const std::string& path, const Encoding& encoding = {}) {
  const std::string header =
      make_encoder(format, path, encoding)->header({.vertices = 3, .faces = 1});
  for (const auto& [begin, name] :
       std::vector<std::pair<std::string, std::string>>{{"ply\nformat ascii", "ply text"},
                                                        {"ply\n", "ply"},
                                                        {"binary STL", "stl"},
                                                        {"solid", "stl text"},
                                                        {"#", "obj"},
                                                        {"OFF\n", "off"},
                                                        {"glTF", "glb"}}) {
    if (header.starts_with(begin)) return name;
  }
  return header.empty() ? "m" : "none";
}

ErrorKind refusal(Format format, const std::string& path, const Encoding& encoding = {}) {
  return error_of([&] { (void)make_encoder(format, path, encoding); }).kind();
}

}  // namespace

TEST_CASE("the name's ending chooses the format") {
  for (const char* path : {"a.stl", "dir.ply/b.STL", ".stl", "x.y.Stl", "a.stl.gz", "b.STL.zst"})
    CHECK(format_of(Format::automatic, path) == "stl");
  for (const char* path : {"a.ply", "-", "", "stl", "a.stl.bak", "b.stl/c", "a.gz", "a.ply.zst"})
    CHECK(format_of(Format::automatic, path) == "ply");
  CHECK(format_of(Format::automatic, "a.obj") == "obj");
  CHECK(format_of(Format::automatic, "a.OFF.gz") == "off");
  CHECK(format_of(Format::automatic, "a.M.zst") == "m");
  CHECK(format_of(Format::automatic, "a.glb") == "glb");
  CHECK(format_of(Format::stl, "a.ply") == "stl");
  CHECK(format_of(Format::ply, "a.stl") == "ply");
}

TEST_CASE("nobody who names an output like another format means a PLY") {
  for (const char* path : {"a.gltf", "a.3mf", "a.gltf.gz", "a.ply.xz"}) {
    CHECK(refusal(Format::automatic, path) == ErrorKind::usage);
    CHECK(format_of(Format::ply, path) == "ply");
  }
}

TEST_CASE("text and doubles are for formats that have them") {
  const Encoding text{.ascii = true};
  CHECK(format_of(Format::ply, "-", text) == "ply text");
  CHECK(format_of(Format::stl, "-", text) == "stl text");
  CHECK(format_of(Format::obj, "-", text) == "obj");
  CHECK(format_of(Format::off, "-", text) == "off");
  CHECK(refusal(Format::gltf, "-", text) == ErrorKind::usage);
  const Encoding doubles{.positions = Positions::doubles};
  CHECK(refusal(Format::gltf, "-", doubles) == ErrorKind::usage);
  CHECK(refusal(Format::automatic, "a.stl", doubles) == ErrorKind::usage);
  const Encoding packed{.compress = Compression::meshopt};
  for (const Format format : {Format::ply, Format::obj, Format::off, Format::m}) {
    CHECK_NOTHROW(make_encoder(format, "-", doubles));
    CHECK(refusal(format, "-", packed) == ErrorKind::usage);
  }
  for (const Format format : {Format::ply, Format::stl, Format::obj, Format::off, Format::m}) {
    CHECK(refusal(format, "-", {.quantize = 12}) == ErrorKind::usage);
    CHECK(refusal(format, "-", {.up = UpAxis::z}) == ErrorKind::usage);
  }
  for (const unsigned bits : {0U, 17U})
    CHECK(refusal(Format::gltf, "-", {.quantize = bits}) == ErrorKind::usage);
  CHECK(make_encoder(Format::gltf, "-", packed)->blocks() != nullptr);
  CHECK(make_encoder(Format::gltf, "-")->blocks() == nullptr);
}

}  // namespace winnow
