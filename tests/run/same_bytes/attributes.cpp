// The same bytes of attributes, too, whatever the threads, the memory and the way in.
#include "support/attributes.hpp"

#include "support/random.hpp"
#include "support/simplified.hpp"

namespace winnow::test {

TEST_CASE("the same attributes with any threads budget and way in", "[same_bytes]") {
  const Directory directory;
  const std::string input = directory.file("in.ply");
  write_attributed(input, generated(directory.path(), 200'000), usual_columns());
  const std::string packed = zstd_file(input);
  std::uint64_t spilled = 0;
  for (const Words& options : {Words{"--grid", "200"}, Words{"--faces", "20001"},
                               Words{"--faces", "20001", "--detail", "4"},
                               Words{"--error", "0.002", "--attributes", "colors,stamp"}}) {
    INFO(joined(options));
    const Simplified one = simplified(directory, input, options + Words{"--threads", "1"});
    const std::string smallest = smallest_memory(input, options + Words{"--threads", "4"});
    const Simplified small =
        simplified(directory, input, options + Words{"--threads", "4", "--memory", smallest});
    const Simplified through = simplified(directory, packed, options + Words{"--threads", "2"});
    CHECK(small.hash == one.hash);
    CHECK(through.hash == one.hash);
    CHECK(small.report["attributes"] == one.report["attributes"]);
    spilled += small.report["spilled_bytes"].get<std::uint64_t>();
  }
  CHECK(spilled > 0);
}

TEST_CASE("the same attributes through a pipe that is read once", "[same_bytes]") {
  const Directory directory;
  const std::string input = directory.file("in.ply");
  write_attributed(input, generated(directory.path(), 60'000), usual_columns());
  const Words options{"--cell", "0.02"};
  const Simplified one = simplified(directory, input, options);
  const std::string output = directory.file("piped.ply");
  Program program(Words{"simplify", "-", "-o", output} + options, {.in = "|"});
  CHECK(program.write(bytes_of_file(input)));
  REQUIRE(program.wait().code == 0);
  CHECK(hash_of_file(output) == one.hash);
  const std::string text = directory.file("text.ply");
  write_attributed(text, read_attributed(input), usual_columns(), PlyForm::ascii);
  CHECK(simplified(directory, text, options).hash == one.hash);
}

TEST_CASE("the same attributes of faces that jump over more vertices than memory has room for",
          "[same_bytes]") {
  const Directory directory;
  AttributedMesh mesh = generated(directory.path(), 1'300'000);
  const std::string coherent = directory.file("scan.ply");
  write_attributed(coherent, mesh, usual_columns());
  Random random(77);
  random.shuffle(mesh.faces);
  const std::string shuffled = directory.file("shuffled.ply");
  write_attributed(shuffled, mesh, usual_columns());
  const Words options{"--cell", "0.02", "--threads", "2"};
  const Simplified want = simplified(directory, coherent, options);
  const Words little = options + Words{"--memory", smallest_memory(shuffled, options)};
  // Sorted by their vertices; in their order, with each corner's position and attributes.
  for (const bool strict : {false, true}) {
    const Simplified small =
        simplified(directory, shuffled, strict ? little + Words{"--strict"} : little);
    CHECK(small.report["spilled_bytes"] >= (strict ? 3 * (4 + 12 + 8) : 12) * mesh.faces.size());
    CHECK(small.hash == want.hash);
    CHECK(small.report["attributes"] == want.report["attributes"]);
  }
}

}  // namespace winnow::test
