// The budget never changes a byte, whether cells and faces are spilled to scratch or not.
#include "support/simplified.hpp"

namespace winnow::test {

namespace {

void compare_budgets(const std::string& surface, const std::string& format,
                     const std::string& output) {
  const Directory directory;
  const std::string input = directory.file(surface + "." + format);
  generate(surface, 320'000, input);
  // Fine enough that the smallest budget holds neither all cells nor all faces.
  for (const Words& how : {Words{"--cell", "0.003", "--placement", "mean"},
                           Words{"--cell", "0.003", "--placement", "quadric"},
                           Words{"--grid", "600", "--placement", "quadric"},
                           Words{"--faces", "250k", "--refine", "none", "--placement", "quadric"},
                           Words{"--ratio", "80%", "--refine", "none", "--placement", "mean"}}) {
    const Words options = how + Words{"--threads", "2"};
    INFO(surface << "." << format << " " << joined(options));
    const Simplified large =
        simplified(directory, input, options + Words{"--memory", "8G"}, {}, output);
    CHECK(large.report["spilled_bytes"] == 0);
    const std::string smallest = smallest_memory(input, options);
    const Simplified small =
        simplified(directory, input, options + Words{"--memory", smallest}, {}, output);
    CHECK(small.report["spilled_bytes"] > 0);
    CHECK(small.hash == large.hash);
    CHECK(simplified(directory, input, options + Words{"--memory", "64M"}, {}, output).hash ==
          large.hash);
    // What a run counts is a result, too.
    for (const char* count :
         {"input", "output", "cells", "reoriented_faces", "merged_opposite_faces",
          "weight_clamped_faces", "cell_size", "cluster_passes", "notes"}) {
      CHECK(small.report[count] == large.report[count]);
    }
  }
}

}  // namespace

TEST_CASE("the same bytes with any budget PLY to PLY", "[same_bytes]") {
  compare_budgets("scan", "ply", "out.ply");
}
TEST_CASE("the same bytes with any budget STL to STL", "[same_bytes]") {
  compare_budgets("terrain", "stl", "out.stl");
}

}  // namespace winnow::test
