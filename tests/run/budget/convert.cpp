// Converting stays within the budget, for meshes that are several times as large.
#include "support/budget.hpp"

namespace winnow::test {

namespace {

void check_convert(const char* from, const char* to, std::uint64_t faces, const Words& options) {
  const Directory directory;
  const std::string input = directory.file(from);
  generate("scan", faces, input);
  const std::string output = directory.file(to);
  const Words command = Words{"convert", input, "--threads", "2"} + options;
  // Compressing takes memory of its own.
  const std::string memory = std::to_string(std::stoi(smallest_memory_of(command)) + 4) + "M";
  INFO(joined(command) << " -o " << to << " --memory " << memory);
  const Run run = run_winnow(command + Words{"-o", output, "--json", "--memory", memory});
  check_peak(run, memory);
  CHECK(run.json()["spilled_bytes"] > 16 * mebibyte);
  CHECK(run.json()["output"]["bytes"] > bytes_of_size(memory));
}

}  // namespace

TEST_CASE("converting a PLY to GLB stays within the smallest budget", "[budget]") {
  check_convert("scan.ply", "out.glb", 3'000'000, {});
}
TEST_CASE("converting a PLY to STL stays within the smallest budget", "[budget]") {
  check_convert("scan.ply", "out.stl", 1'500'000, {});
}
TEST_CASE("converting an STL to a compressed PLY stays within the smallest budget", "[budget]") {
  check_convert("scan.stl", "out.ply.zst", 2'500'000, {});
}
TEST_CASE("converting to text stays within the smallest budget", "[budget]") {
  check_convert("scan.ply", "out.obj.gz", 1'200'000, {});
}

}  // namespace winnow::test
