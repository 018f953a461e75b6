// Attributes stay within the budget: their table, their means, and those of tiles.
#include "support/attributes.hpp"

#include "support/budget.hpp"

namespace winnow::test {

namespace {

void check_attributes(const Words& options, const std::string& memory) {
  const Directory directory;
  const std::string input = directory.file("in.ply");
  write_attributed(input, generated(directory.path(), 600'000), usual_columns());
  const Run run = check_budget(directory, input, options, memory);
  CHECK(run.json()["attributes"]["carried"].size() == usual_columns().size());
  CHECK(run.json()["spilled_bytes"] > 4 * mebibyte);
}

}  // namespace

TEST_CASE("clustering with attributes stays within the smallest budget", "[budget]") {
  check_attributes({"--cell", "0.003", "--threads", "2"}, "smallest");
}
TEST_CASE("refining with attributes stays within the smallest budget", "[budget]") {
  check_attributes({"--faces", "100k", "--threads", "2"}, "smallest");
}

}  // namespace winnow::test
