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
        CHECK(simplified(directory, shuffled,
                         options + Words{"--memory", smallest_memory(shuffled, options)})
                  .hash == want.hash);
      }
    }
    // Box and sample come from the vertices of a PLY.
    for (const Words& options :
         {Words{"--grid", "100"}, Words{"--faces", "10k", "--refine", "none"},
          Words{"--ratio", "30%", "--refine", "none"}}) {
      INFO(surface << " " << joined(options));
      CHECK(simplified(directory, shuffled, options).hash ==
            simplified(directory, coherent, options).hash);
    }
  }
}

TEST_CASE("the same bytes from faces that jump over more vertices than memory has room for",
          "[same_bytes]") {
  const Directory directory;
  const std::string coherent = directory.file("scan.ply");
  const std::string shuffled = directory.file("shuffled.ply");
  constexpr std::uint64_t faces = 1'300'000;
  generate("scan", faces, coherent);
  generate("scan", faces, shuffled, {.shuffle = true});
  const auto little = [&](const Words& options) {
    return options + Words{"--memory", smallest_memory(shuffled, options), "--force"};
  };
  for (const Words& options :
       {Words{"--cell", "0.02", "--threads", "2"}, Words{"--faces", "10k", "--threads", "1"}}) {
    INFO(joined(options));
    const Simplified want = simplified(directory, coherent, options);
    // Sorted by their vertices; in their order, with each corner's position.
    for (const bool strict : {false, true}) {
      const Words same = strict ? options + Words{"--strict"} : options;
      const Simplified small = simplified(directory, shuffled, little(same));
      CHECK(small.report["spilled_bytes"] >= (strict ? 3 * 16 : 16) * faces);
      CHECK(small.report["input"] == want.report["input"]);
      CHECK(small.hash == want.hash);
    }
    CHECK(simplified_by_pipe(directory, shuffled, little(options)).hash == want.hash);
  }
  const Words whole{"--faces", "1.2M", "--detail", "full"};
  CHECK(simplified(directory, shuffled, little(whole)).hash ==
        simplified(directory, coherent, whole).hash);
  // The order of the faces is kept, too.
  const std::string large = directory.file("large.stl");
  const std::string small = directory.file("small.stl");
  winnow_ok({"convert", shuffled, "-o", large, "-q"});
  const std::string memory = smallest_memory_of({"convert", shuffled, "--threads", "2"});
  winnow_ok({"convert", shuffled, "-o", small, "-q", "--threads", "2", "--memory", memory});
  CHECK(hash_of_file(small) == hash_of_file(large));
}

}  // namespace winnow::test
