// Refinement stays within the budget: tiles, what comes out of a round, and the lists in between.
#include "support/budget.hpp"

namespace winnow::test {

namespace {

void check_refined(const char* name, std::uint64_t faces, const Words& options,
                   const std::string& memory, const char* surface = "scan") {
  const Directory directory;
  const std::string input = directory.file(name);
  generate(surface, faces, input);
  const Run run = check_budget(directory, input, options, memory);
  const nlohmann::json report = run.json();
  CHECK(report["refine"]["tiles"] > 5);
  CHECK(report["spilled_bytes"] > 8 * mebibyte);
}

}  // namespace

TEST_CASE("refining all faces stays within the smallest budget", "[budget]") {
  check_refined("scan.ply", 1'000'000, {"--faces", "100k", "--threads", "2"}, "smallest");
}
TEST_CASE("refining a clustered STL to an error stays within the smallest budget", "[budget]") {
  check_refined("scan.stl", 1'200'000, {"--error", "0.0003", "--threads", "1"}, "smallest");
}
TEST_CASE("keeping boundaries of what is clustered stays within the smallest budget", "[budget]") {
  check_refined("terrain.ply", 2'000'000, {"--ratio", "4%", "--boundary", "keep", "--threads", "2"},
                "smallest", "terrain");
}
TEST_CASE("refining with many threads stays within a budget of 128 MiB", "[budget]") {
  check_refined("scan.ply", 1'000'000, {"--ratio", "50%", "--normals", "--threads", "8"}, "128M");
}

}  // namespace winnow::test
