// An output, a table and a list of faces larger than the budget go through scratch.
#include "support/budget.hpp"

namespace winnow::test {

namespace {

// Cells far below the spacing: every vertex stays.
void check_whole(const char* name, std::uint64_t faces, const Words& options,
                 const std::string& memory) {
  const Directory directory;
  const std::string input = directory.file(name);
  generate("scan", faces, input);
  const Run run =
      check_budget(directory, input, options + Words{"--cell", "0.0002", "--threads", "2"}, memory);
  const nlohmann::json report = run.json();
  CHECK(report["output"]["faces"] > faces * 9 / 10);
  CHECK(report["spilled_bytes"] > 64 * mebibyte);
}

}  // namespace

TEST_CASE("an output larger than the smallest budget from PLY", "[budget]") {
  check_whole("scan.ply", 2'000'000, {}, "smallest");
}
TEST_CASE("an output larger than the smallest budget from STL", "[budget]") {
  check_whole("scan.stl", 1'600'000, {"--placement", "quadric"}, "smallest");
}
TEST_CASE("an output larger than a budget of 64 MiB", "[budget]") {
  check_whole("scan.ply", 2'700'000, {"--normals"}, "64M");
}
TEST_CASE("more cells and faces than a budget of 128 MiB holds", "[budget]") {
  check_whole("scan.ply", 2'600'000, {}, "128M");
}

TEST_CASE("an STL output larger than the budget", "[budget]") {
  const Directory directory;
  const std::string input = directory.file("scan.ply");
  generate("scan", 1'000'000, input);
  const std::string output = directory.file("out.stl");
  const Words options{"--cell", "0.0002", "--threads", "2"};
  const std::string memory = smallest_memory(input, options);
  check_peak(
      run_winnow(Words{"simplify", input, "-o", output, "--json", "--memory", memory} + options),
      memory);
  CHECK(size_of_file(output) > bytes_of_size(memory));
}

}  // namespace winnow::test
