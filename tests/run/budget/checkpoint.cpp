// A run with a checkpoint stays within its budget, and so does the one that goes on.
#include "support/budget.hpp"

#include <csignal>

namespace winnow::test {

TEST_CASE("refining with a checkpoint stays within the smallest budget, resumed too", "[budget]") {
  const Directory directory;
  const std::string input = directory.file("scan.ply");
  const std::string output = directory.file("out.ply");
  generate("scan", 700'000, input);
  for (const Words& options :
       {Words{"--faces", "100k", "--threads", "2"}, Words{"--error", "0.0003", "--threads", "1"}}) {
    const std::string memory = smallest_memory(input, options);
    const Words speed{"--json", "--memory", memory};
    INFO(joined(options) << " --memory " << memory);
    const std::string kept = directory.file("kept");
    const Words checkpoint{"--checkpoint", kept};
    check_budget(directory, input, options + checkpoint, memory);
    // Killed when the first round's mesh is brought to the disk.
    const Run killed =
        run_winnow(Words{"simplify", input, "-o", output} + options + speed + checkpoint,
                   {.fault = "change 1 0 kept/stage-1"});
    REQUIRE(killed.signal == SIGKILL);
    const Run resumed = run_winnow(Words{"resume", kept, "--threads", options.back()} + speed);
    check_peak(resumed, memory);
    CHECK(resumed.json()["resumed"]["tiles"] > 5);
    ::unlink(output.c_str());
  }
}

}  // namespace winnow::test
