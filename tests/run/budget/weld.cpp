// Joining near vertices stays within the budget, however many move and however many there are.
#include "support/budget.hpp"
#include "support/stl_file.hpp"

namespace winnow::test {

TEST_CASE("joining the corners of a million faces stays within the smallest budget",
          "[budget][weld]") {
  const Directory directory;
  const std::string input = directory.file("scan.stl");
  generate("scan", 1'000'000, input);
  // Edges are about 0.004 long: next to none move, or nearly all.
  for (const char* distance : {"0.0001", "0.003"}) {
    const Run run = check_budget(
        directory, input, {"--cell", "0.05", "--threads", "2", "--weld", distance}, "smallest");
    CHECK(run.json()["spilled_bytes"] > 8 * mebibyte);
  }
}

TEST_CASE("more vertices within a distance than memory holds name a budget that does",
          "[budget][weld]") {
  const Directory directory;
  const std::string input = directory.file("dust.stl");
  Random random(3);
  write_file(input, binary_stl(random_triangles(random, 200'000, 1)));
  const Words options{"--faces", "100", "--weld", "90", "--threads", "1"};
  const std::string small = smallest_memory(input, options);
  const Run run = run_winnow(
      Words{"simplify", input, "-o", directory.file("none.ply"), "--memory", small} + options);
  CHECK(run.code == 4);
  CHECK(run.err.find("vertices within one distance of --weld") != std::string::npos);
  // With that nothing is left, which is another message.
  const Run enough = run_winnow(
      Words{"simplify", input, "-o", directory.file("none.ply"), "--memory", "1G"} + options);
  CHECK(enough.code == 3);
  CHECK(enough.err.find("--weld") != std::string::npos);
}

}  // namespace winnow::test
