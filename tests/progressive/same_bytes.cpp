// The same file for any threads and memory, from a file and from a pipe, within the budget.
#include "support/budget.hpp"
#include "support/files.hpp"
#include "support/program.hpp"

namespace winnow::test {

namespace {

const Words quiet{"--json", "--force"};

std::string built(const Directory& directory, const std::string& input, const Words& more) {
  const std::string output = directory.file("out.wpm");
  winnow_ok(Words{"progressive", input, "-o", output} + quiet + more);
  return hash_of_file(output);
}

}  // namespace

TEST_CASE("progressive files do not depend on threads, memory or pipes",
          "[progressive][same_bytes]") {
  const Directory directory;
  const std::string input = directory.file("scan.ply");
  generate("scan", 300'000, input);
  const std::string hash = built(directory, input, {"--threads", "1"});
  CHECK(built(directory, input, {"--threads", "2"}) == hash);
  CHECK(built(directory, input, {"--threads", "7"}) == hash);
  CHECK(built(directory, input, {"--memory", "128M"}) == hash);
  CHECK(built(directory, input, {"--bits", "16"}) != hash);
  const std::string output = directory.file("piped.wpm");
  Program program(Words{"progressive", "-", "-o", output} + quiet, {.in = "|"});
  CHECK(program.write(bytes_of_file(input)));
  REQUIRE(program.wait().code == 0);
  CHECK(hash_of_file(output) == hash);

  const std::string level = directory.file("level.ply");
  winnow_ok(Words{"extract", output, "-o", level, "--faces", "20k"} + quiet);
  const std::string level_hash = hash_of_file(level);
  winnow_ok(
      Words{"extract", output, "-o", level, "--faces", "20k", "--threads", "1", "--memory", "64M"} +
      quiet);
  CHECK(hash_of_file(level) == level_hash);
  Program piped(Words{"extract", "-", "-o", level, "--faces", "20k"} + quiet, {.in = "|"});
  piped.write(bytes_of_file(output));
  REQUIRE(piped.wait().code == 0);
  CHECK(hash_of_file(level) == level_hash);
}

TEST_CASE("progressive files are made and read within the budget", "[progressive][budget]") {
  const Directory directory;
  const std::string input = directory.file("scan.ply");
  generate("scan", 1'500'000, input);
  const std::string output = directory.file("out.wpm");
  check_peak(run_winnow(Words{"progressive", input, "-o", output, "--memory", "128M"} + quiet),
             "128M");
  // In memory, and where there is no room for it.
  const std::string level = directory.file("level.ply");
  const Words extract{"extract", output, "-o", level, "--ratio", "40%"};
  check_peak(run_winnow(extract + quiet + Words{"--memory", "1024M"}), "1024M");
  const std::string hash = hash_of_file(level);
  check_peak(run_winnow(extract + quiet + Words{"--memory", "128M"}), "128M");
  CHECK(hash_of_file(level) == hash);
}

}  // namespace winnow::test
