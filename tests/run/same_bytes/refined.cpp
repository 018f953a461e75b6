// What changes no byte of a clustered mesh changes none of a refined one: threads, memory, file or
// pipe.
#include "support/simplified.hpp"

#include <tuple>

namespace winnow::test {

namespace {

void check_same(const Simplified& a, const Simplified& b) {
  CHECK(a.hash == b.hash);
  // What a run counts is a result, too.
  for (const char* count : {"input", "output", "target", "refine", "cells", "split_cells",
                            "merged_opposite_faces", "cell_size", "cluster_passes", "notes"}) {
    INFO(count);
    CHECK(a.report[count] == b.report[count]);
  }
}

}  // namespace

TEST_CASE("the same refined bytes with any threads budget and way in", "[same_bytes]") {
  const Directory directory;
  const std::string input = directory.file("scan.ply");
  generate("scan", 300'000, input);
  std::uint64_t spilled = 0;
  // All faces refined, in several tiles; clustered first; down to an error, with quadrics that
  // remember.
  for (const Words& options :
       {Words{"--faces", "20001"}, Words{"--faces", "20001", "--detail", "4"},
        Words{"--ratio", "10%", "--normals", "--boundary", "keep"},
        Words{"--error", "0.002", "--max-normal-deviation", "40"}}) {
    INFO(joined(options));
    const Simplified one = simplified(directory, input, options + Words{"--threads", "1"});
    CHECK(one.report["output"]["faces"] > 1000);
    CHECK(one.report["refine"]["collapses"] > 1000);
    const std::string smallest = smallest_memory(input, options + Words{"--threads", "4"});
    const Simplified small =
        simplified(directory, input, options + Words{"--threads", "4", "--memory", smallest});
    spilled += small.report["spilled_bytes"].get<std::uint64_t>();
    check_same(one, small);
    check_same(one, simplified_by_pipe(directory, input, options + Words{"--threads", "2"}));
  }
  // Not each has to: how much fits depends on how the threads divide the work.
  CHECK(spilled > 0);
}

TEST_CASE("the same refined bytes where cells are split", "[same_bytes]") {
  const Directory directory;
  std::uint64_t spilled = 0;
  const Words clustered{"--ratio", "2%", "--detail", "5"};
  const Words kept = clustered + Words{"--boundary", "keep"};
  for (const auto& [what, faces, options] :
       {std::tuple{"scan.ply", 400'000, clustered}, std::tuple{"scan.stl", 400'000, clustered},
        std::tuple{"terrain.ply", 400'000, clustered},
        std::tuple{"terrain.stl", 400'000, clustered}, std::tuple{"terrain.ply", 400'000, kept},
        std::tuple{"terrain.ply", 1'100'000, Words{"--error", "0.2%"}}}) {
    const std::string input = directory.file(what);
    generate(std::string(what).substr(0, std::string(what).find('.')), faces, input);
    INFO(what << " " << joined(options));
    const Simplified one = simplified(directory, input, options + Words{"--threads", "1"});
    CHECK(one.report["split_cells"] > 10);
    const std::string smallest = smallest_memory(input, options + Words{"--threads", "3"});
    const Simplified small =
        simplified(directory, input, options + Words{"--threads", "3", "--memory", smallest});
    spilled += small.report["spilled_bytes"].get<std::uint64_t>();
    check_same(one, small);
    check_same(one, simplified_by_pipe(directory, input, options + Words{"--threads", "2"}));
    ::unlink(input.c_str());
  }
  CHECK(spilled > 0);
}

TEST_CASE("the same refined bytes of an STL from any source", "[same_bytes]") {
  const Directory directory;
  const std::string input = directory.file("part.stl");
  generate("part", 60'000, input);
  const Words options{"--faces", "5k"};
  const Simplified one = simplified(directory, input, options + Words{"--threads", "1"});
  check_same(one, simplified(directory, input, options + Words{"--threads", "4"}));
  check_same(one, simplified_by_pipe(directory, input, options));
  CHECK(simplified(directory, zstd_file(input), options).hash == one.hash);
}

TEST_CASE("equal faces in PLY and STL give the same refined mesh", "[same_bytes]") {
  // Where nothing is clustered: vertices are welded by position and ordered by place.
  const Directory directory;
  const std::string ply = directory.file("scan.ply");
  const std::string stl = directory.file("scan.stl");
  generate("scan", 60'000, ply);
  generate("scan", 60'000, stl);
  CHECK(simplified(directory, ply, {"--faces", "5k"}).hash ==
        simplified(directory, stl, {"--faces", "5k"}).hash);
}

}  // namespace winnow::test
