// A reader that goes away is a write error: 4, soon, with a message, and no death by SIGPIPE.
#include "support/simplified.hpp"

namespace winnow::test {

namespace {

void check_gone(const Words& arguments, std::size_t read_before) {
  Program program(arguments, {.out = "|"});
  for (std::size_t got = 0; got < read_before;) {
    const std::string part = program.read(4096);
    REQUIRE_FALSE(part.empty());
    got += part.size();
  }
  program.close_out();
  const Run run = program.wait();
  INFO(joined(arguments) << "\n" << run.err);
  CHECK(run.signal == 0);
  CHECK(run.code == 4);
  CHECK(run.err.find("the reader of standard output went away") != std::string::npos);
}

}  // namespace

TEST_CASE("a reader that goes away ends the program with 4", "[faults]") {
  const Directory directory;
  const std::string input = directory.file("scan.ply");
  generate("scan", 200'000, input);
  for (const std::size_t read_before : {0, 1, 100'000}) {
    for (const char* format : {"ply", "stl"}) {
      check_gone({"simplify", input, "-o", "-", "--cell", "0.001", "--to", format}, read_before);
      check_gone({"generate", "scan", "--faces", "10M", "-o", "-", "--to", format}, read_before);
    }
  }
  CHECK(directory.names() == Words{"scan.ply"});
}

TEST_CASE("a report that nobody reads does not change the result", "[faults]") {
  const Directory directory;
  const std::string input = directory.file("scan.ply");
  generate("scan", 20'000, input);
  const std::string output = directory.file("out.ply");
  Program program({"simplify", input, "-o", output, "--grid", "50", "--json"}, {.out = "|"});
  program.close_out();
  const Run run = program.wait();
  CHECK(run.signal == 0);
  CHECK(hash_of_file(output) ==
        simplified(directory, input, {"--grid", "50"}, {}, "again.ply").hash);
}

}  // namespace winnow::test
