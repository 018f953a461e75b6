// The order of the faces never changes a byte, as long as the vertices keep theirs.
#include "support/simplified.hpp"

namespace winnow::test {

TEST_CASE("the same bytes from faces in a scattered order", "[same_bytes]") {
  const Directory directory;
  for (const char* surface : {"scan", "terrain", "part"}) {
    const std::string coherent = directory.file(std::string(surface) + ".ply");
    const std::string shuffled = directory.file(std::string(surface) + "-shuffled.ply");
    generate(surface, 60'000, coherent);
    generate(surface, 60'000, shuffled, {.shuffle = true});
    REQUIRE(hash_of_file(shuffled) != hash_of_file(coherent));
    // Cells of many faces, and cells so small that the smallest budget spills.
    for (const char* cell : {"0.3", "0.004"}) {
      for (const char* placement : {"mean", "quadric"}) {
        const Words options{"--cell", cell, "--placement", placement};
        INFO(surface << " " << joined(options));
        const Simplified want = simplified(directory, coherent, options);
        CHECK(simplified(directory, shuffled, options + Words{"--threads", "3"}).hash == want.hash);
        CHECK(simplified(directory, shuffled, options + Words{"--memory", smallest_memory(shuffled, options)})
                  .hash == want.hash);
      }
    }
    // Box and sample come from the vertices of a PLY.
    for (const Words& options : {Words{"--grid", "100"}, Words{"--faces", "10k", "--refine", "none"},
                                 Words{"--ratio", "30%", "--refine", "none"}}) {
      INFO(surface << " " << joined(options));
      CHECK(simplified(directory, shuffled, options).hash == simplified(directory, coherent, options).hash);
    }
  }
}

}  // namespace winnow::test
