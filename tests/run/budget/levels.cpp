// Several results of one run stay within the budget: each goes on from a mesh that is kept beside.
#include "support/budget.hpp"

namespace winnow::test {

TEST_CASE("several counts in one run stay within the smallest budget of the largest", "[budget]") {
  const Directory directory;
  const std::string input = directory.file("in.ply");
  generate("scan", 1'000'000, input);
  const std::string memory = smallest_memory(input, {"--faces", "400k", "--threads", "2"});
  const Run run =
      run_winnow({"simplify", input, "-o", directory.file("level-{faces}.ply"), "--faces",
                  "400k,100k,5k", "--threads", "2", "--memory", memory, "--json"});
  check_peak(run, memory);
  const nlohmann::json report = run.json();
  CHECK(report["spilled_bytes"] > 8 * mebibyte);
  CHECK(report["levels"][2]["output"]["faces"] == 5000);
}

}  // namespace winnow::test
