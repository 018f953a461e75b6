// Faces in a scattered order over more vertices than the budget holds.
#include "support/budget.hpp"

namespace winnow::test {

TEST_CASE("scattered faces stay within the budget", "[budget]") {
  const Directory directory;
  const std::string input = directory.file("scan.ply");
  // The vertices take a quarter of what is left of the budget; these are larger.
  constexpr std::uint64_t faces = 1'300'000;
  generate("scan", faces, input, {.shuffle = true});
  const auto check = [&](const Words& options, std::uint64_t bytes_a_face) {
    const nlohmann::json report = check_budget(directory, input, options, "smallest").json();
    CHECK(report["spilled_bytes"] >= bytes_a_face * faces);
    const nlohmann::json plan =
        winnow_ok(Words{"simplify", input, "-o", directory.file("out.ply"), "--json", "--dry-run",
                        "--memory", smallest_memory(input, options)} +
                  options)
            .json();
    CHECK(report["peak_scratch_bytes"] <= plan["scratch_worst"]);
  };
  // Sorted, the numbers of a face's vertices go through scratch.
  check({"--cell", "0.02", "--threads", "2"}, 12);
  check({"--cell", "0.02", "--threads", "1"}, 12);
  // Cells that do not fit, either.
  check({"--cell", "0.006", "--threads", "2"}, 12);
  // In their order, their positions besides.
  check({"--cell", "0.02", "--threads", "2", "--strict"}, 3 * 16);
  // Faces that can be read once.
  check_budget(directory, zstd_file(input), {"--cell", "0.02", "--threads", "2"}, "smallest");
}

}  // namespace winnow::test
