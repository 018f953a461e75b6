// Fitting stays within the budget that the rest of the run works in.
#include "support/budget.hpp"

namespace winnow::test {

TEST_CASE("a fitted run stays within the smallest budget", "[budget]") {
  const Directory directory;
  const std::string input = directory.file("in.ply");
  generate("scan", 1'000'000, input);
  const Words options{"--ratio", "30%", "--fit", "2", "--threads", "2"};
  const Run run = check_budget(directory, input, options, "smallest");
  CHECK(run.json()["fit"]["samples"] > 3'500'000);
  CHECK(run.json()["spilled_bytes"] > 8 * mebibyte);
}

}  // namespace winnow::test
