// A mesh as text and the same mesh in binary give the same bytes.
#include "support/simplified.hpp"

namespace winnow::test {

TEST_CASE("the same bytes from ASCII and binary of the same floats", "[same_bytes]") {
  const Directory directory;
  for (const char* format : {".ply", ".stl"}) {
    for (const char* surface : {"scan", "terrain", "part"}) {
      const std::string binary = directory.file(std::string(surface) + format);
      generate(surface, 20'000, binary);
      const std::string ascii =
          ascii_file(binary, directory.file(std::string(surface) + "-ascii" + format));
      for (const Words& options : {Words{"--cell", "0.03"}, Words{"--grid", "50"},
                                   Words{"--faces", "3000", "--refine", "none"},
                                   Words{"--ratio", "20%", "--refine", "none"}}) {
        INFO(surface << format << " " << joined(options));
        const Simplified want = simplified(directory, binary, options);
        CHECK(simplified(directory, ascii, options).hash == want.hash);
        if (options[0] == "--grid")
          CHECK(simplified(directory, gzip_file(ascii), options).hash == want.hash);
      }
    }
  }
}

TEST_CASE("the same bytes from OBJ, OFF, .m and GLB as from PLY with the same floats",
          "[same_bytes]") {
  const Directory directory;
  for (const char* surface : {"scan", "part"}) {
    const std::string binary = directory.file(std::string(surface) + ".ply");
    generate(surface, 20'000, binary);
    for (const Words& options : {Words{"--cell", "0.03"}, Words{"--faces", "3000"},
                                 Words{"--ratio", "20%", "--refine", "none"}}) {
      const Simplified want = simplified(directory, binary, options);
      for (const std::string format : {".obj", ".off", ".m", ".glb"}) {
        INFO(surface << format << " " << joined(options));
        const std::string name = directory.file(surface + format);
        const std::string other =
            format == ".glb" ? glb_file(binary, name) : ascii_file(binary, name);
        CHECK(simplified(directory, other, options).hash == want.hash);
        CHECK(simplified(directory, other, options + Words{"--memory", "40M", "--threads", "1"})
                  .hash == want.hash);
        CHECK(simplified(directory, "-", options, {.in = other}).hash == want.hash);
        CHECK(simplified(directory, gzip_file(other), options).hash == want.hash);
      }
    }
  }
}

}  // namespace winnow::test
