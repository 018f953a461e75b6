// What changes no byte of a mesh changes none of a welded one: threads, memory, file or pipe,
// resuming.
#include "support/attributes.hpp"
#include "support/budget.hpp"
#include "support/checkpoints.hpp"
#include "support/simplified.hpp"

namespace winnow::test {

namespace {

void check_same(const Simplified& a, const Simplified& b) {
  CHECK(a.hash == b.hash);
  for (const char* count : {"input", "output", "weld", "refine", "cells", "notes"}) {
    INFO(count);
    CHECK(a.report[count] == b.report[count]);
  }
}

}  // namespace

TEST_CASE("the same welded bytes with any threads budget and way in", "[same_bytes][weld]") {
  const Directory directory;
  const std::string input = directory.file("scan.ply");
  generate("scan", 150'000, input);
  // From a few vertices to nearly all: edges are about 0.01 long.
  for (const Words& options :
       {Words{"--faces", "9001", "--weld", "0.004"}, Words{"--grid", "90", "--weld", "0.006"},
        Words{"--cell", "0.02", "--weld", "0.05%"}}) {
    INFO(joined(options));
    const Simplified one = simplified(directory, input, options + Words{"--threads", "1"});
    CHECK(one.report["weld"]["vertices"] > 10);
    CHECK(one.report["weld"]["collapsed_faces"] > 10);
    for (const char* threads : {"2", "7"})
      check_same(one, simplified(directory, input, options + Words{"--threads", threads}));
    const Words two = options + Words{"--threads", "2"};
    const Simplified small =
        simplified(directory, input, two + Words{"--memory", smallest_memory(input, two)});
    check_same(one, small);
    check_same(one, simplified_by_pipe(directory, input, two));
  }
}

TEST_CASE("attributes of joined vertices are averaged the same way everywhere",
          "[same_bytes][weld]") {
  const Directory directory;
  const std::string input = directory.file("columns.ply");
  write_attributed(input, generated(directory.path(), 20'000), usual_columns());
  const Words options{"--faces", "4000", "--weld", "0.02"};
  const Simplified one = simplified(directory, input, options + Words{"--threads", "1"});
  CHECK(one.report["weld"]["vertices"] > 100);
  CHECK(one.report["attributes"]["carried"].size() > 3);
  check_same(one, simplified(directory, input, options + Words{"--threads", "3"}));
  check_same(one, simplified_by_pipe(directory, input, options));
}

TEST_CASE("a run that welds goes on where it was stopped", "[faults][weld]") {
  const Directory directory;
  const std::string input = directory.file("scan.ply"), output = directory.file("out.ply");
  generate("scan", 60'000, input);
  for (const bool relative : {false, true}) {
    SimplifyOptions options;
    options.target = Target::faces(5'000);
    options.weld = relative ? Distance::of_diagonal(0.003) : Distance(0.003);
    Context context;
    const SimplifyReport right = simplify(context, input, output, options);
    const std::string want = hash_of_file(output);
    ::unlink(output.c_str());
    CHECK(right.weld.faces > 0);
    for (const char* stage : {"find neighbours", "refine"}) {
      INFO(stage);
      const SimplifyReport report = resumed(stopped_at(directory, {input}, output, options, stage));
      CHECK(hash_of_file(output) == want);
      CHECK(report.weld.distance == right.weld.distance);
      CHECK(report.weld.vertices == right.weld.vertices);
      CHECK(report.weld.faces == right.weld.faces);
      ::unlink(output.c_str());
    }
  }
}

}  // namespace winnow::test
