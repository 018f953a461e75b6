// Faces in a scattered order over more vertices than the budget holds.
#include "support/budget.hpp"

namespace winnow::test {

TEST_CASE("scattered faces stay within the budget", "[budget]") {
  const Directory directory;
  const std::string input = directory.file("scan.ply");
  // The vertices take a quarter of what is left of the budget; these are larger.
  constexpr std::uint64_t faces = 1'300'000;
  generate("scan", faces, input, {.shuffle = true});
  const auto check = [&](const Words& options) {
    // Each corner's number and position go through scratch.
    const nlohmann::json report = check_budget(directory, input, options, "smallest").json();
    CHECK(report["spilled_bytes"] >= 3 * 16 * faces);
    const nlohmann::json plan = winnow_ok(Words{"simplify", input, "-o", directory.file("out.ply"), "--json",
                                                "--dry-run", "--memory", smallest_memory(input, options)} +
                                          options)
                                    .json();
    CHECK(report["peak_scratch_bytes"] <= plan["scratch_worst"]);
  };
  check({"--cell", "0.02", "--threads", "2"});
  check({"--cell", "0.02", "--threads", "1"});
  // Cells that do not fit, either.
  check({"--cell", "0.006", "--threads", "2"});
  // Faces that can be read once.
  check_budget(directory, zstd_file(input), {"--cell", "0.02", "--threads", "2"}, "smallest");
}

}  // namespace winnow::test
