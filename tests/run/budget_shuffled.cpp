// Faces in a scattered order over more vertices than the budget holds.
#include "support/budget.hpp"

namespace winnow::test {

TEST_CASE("scattered faces stay within the budget", "[budget]") {
  const Directory directory;
  const std::string input = directory.file("scan.ply");
  // The vertices take a quarter of what is left of the budget; these are larger.
  generate("scan", 1'300'000, input, {.shuffle = true});
  check_budget(directory, input, {"--cell", "0.006", "--threads", "2"}, "smallest");
}

}  // namespace winnow::test
