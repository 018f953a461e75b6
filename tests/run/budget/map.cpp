// Telling where vertices went stays within the budget, in scratch beyond it.
#include "support/budget.hpp"

namespace winnow::test {

namespace {

void check_mapped(const char* name, std::uint64_t faces, const Words& options) {
  const Directory directory;
  const std::string input = directory.file(name);
  generate("scan", faces, input);
  const Run run = check_budget(
      directory, input, options + Words{"--map", directory.file("map.npy"), "--force"}, "smallest");
  CHECK(run.json()["spilled_bytes"] > 8 * mebibyte);
}

}  // namespace

TEST_CASE("a map through several rounds stays within the smallest budget", "[budget][map]") {
  check_mapped("scan.ply", 1'000'000, {"--faces", "100k", "--threads", "2"});
}
TEST_CASE("a map of an STL that is clustered stays within the smallest budget", "[budget][map]") {
  check_mapped("scan.stl", 2'000'000, {"--faces", "20k", "--threads", "1"});
}
TEST_CASE("a map of welded cells stays within the smallest budget", "[budget][map]") {
  check_mapped("scan.stl", 1'000'000, {"--cell", "0.005", "--weld", "1e-5", "--threads", "2"});
}

}  // namespace winnow::test
