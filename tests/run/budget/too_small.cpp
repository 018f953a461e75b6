// A budget that is too small is an error at once, and what the message names works.
#include "support/budget.hpp"

namespace winnow::test {

TEST_CASE("a budget that is too small names the smallest that works", "[budget]") {
  const Directory directory;
  const std::string input = directory.file("scan.ply");
  generate("scan", 50'000, input);
  const std::string output = directory.file("out.ply");
  for (const char* threads : {"1", "2", "8", "16", "24", "32", "64"}) {
    for (const char* placement : {"mean", "quadric"}) {
      const Words options{"--grid", "100", "--threads", threads, "--placement", placement};
      INFO(joined(options));
      const std::string smallest = smallest_memory(input, options);
      const Words arguments = Words{"simplify", input, "-o", output, "--json", "--force"} + options;
      const Run enough = run_winnow(arguments + Words{"--memory", smallest});
      INFO(smallest << ": " << enough.err);
      CHECK(enough.code == 0);
      // One byte less than that is not.
      const Run less =
          run_winnow(arguments + Words{"--memory", std::to_string(bytes_of_size(smallest) - 1)});
      CHECK(less.code == 4);
      CHECK(less.err.find("--memory " + smallest) != std::string::npos);
      // The plan knows the same number, whatever the budget.
      for (const std::string& memory : {smallest, std::string("1G")}) {
        const Run plan = winnow_ok(arguments + Words{"--memory", memory, "--dry-run"});
        CHECK(plan.json()["smallest_memory"] == bytes_of_size(smallest));
      }
    }
  }
}

TEST_CASE("a budget of next to nothing is refused and not crashed on", "[budget]") {
  const Directory directory;
  const std::string input = directory.file("scan.ply");
  generate("scan", 2'000, input);
  for (const char* memory : {"0", "1", "1k", "1M", "20M"}) {
    const Run run = run_winnow(
        {"simplify", input, "-o", directory.file("out.ply"), "--grid", "10", "--memory", memory});
    INFO(memory << ": " << run.err);
    CHECK(run.code == 4);
    CHECK(run.err.find("the smallest that works is --memory") != std::string::npos);
  }
  CHECK(directory.names() == Words{"scan.ply"});
}

}  // namespace winnow::test
