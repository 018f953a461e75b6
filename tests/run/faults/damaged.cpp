// A disk that changes a bit of what is in scratch: the run says so, or what it writes is right.
#include "support/simplified.hpp"

namespace winnow::test {

namespace {

// Changes one bit in some of the writes to scratch, from the first to the last, and returns in how
// many runs it was noticed.
int noticed(const Directory& directory, const std::string& input, const Words& options) {
  const Words arguments =
      Words{"simplify", input, "-o", directory.file("out.ply"), "--threads", "2"} + options;
  INFO(joined(arguments));
  winnow_ok(arguments);
  const std::string want = hash_of_file(directory.file("out.ply"));
  int count = 0;
  for (long number = 1;; number += number + 1) {
    ::unlink(directory.file("out.ply").c_str());
    const Run run = run_winnow(arguments, {.fault = "write " + std::to_string(number) + " -1 /#"});
    INFO("write " << number << ": " << run.err);
    REQUIRE(run.signal == 0);
    if (run.code == 0) {
      CHECK(hash_of_file(directory.file("out.ply")) == want);
      if (number <= 40) continue;  // one that is not read again
      ::unlink(directory.file("out.ply").c_str());
      return count;
    }
    CHECK(run.code == 4);
    CHECK(run.err.find("scratch in '" + directory.path() + "' is damaged") != std::string::npos);
    CHECK(run.err.find("--scratch") != std::string::npos);
    CHECK_FALSE(exists(directory.file("out.ply")));
    ++count;
  }
}

}  // namespace

TEST_CASE("a changed bit is noticed in what a run keeps in scratch", "[faults][long]") {
  const Directory directory;
  const std::string input = directory.file("scan.ply");
  generate("scan", 400'000, input);
  const Words clustered{"--cell", "0.0005"};
  CHECK(noticed(directory, input,
                clustered + Words{"--memory", smallest_memory(input, clustered)}) >= 4);
  const Words refined{"--ratio", "40%", "--detail", "full"};
  CHECK(noticed(directory, input, refined + Words{"--memory", smallest_memory(input, refined)}) >=
        4);
}

TEST_CASE("a changed bit is noticed in a copy of the input and in vertices that were parsed",
          "[faults][long]") {
  const Directory directory;
  generate("scan", 400'000, directory.file("scan.stl"));
  CHECK(noticed(directory, zstd_file(directory.file("scan.stl")), {"--grid", "100"}) >= 4);
  const std::string text = directory.file("scan.obj");
  generate("scan", 400'000, directory.file("scan.ply"));
  winnow_ok({"convert", directory.file("scan.ply"), "-o", text});
  const Words options{"--cell", "0.05"};
  CHECK(noticed(directory, text, options + Words{"--memory", smallest_memory(text, options)}) >= 3);
}

TEST_CASE("a changed bit is noticed in faces that were sorted", "[faults][long]") {
  const Directory directory;
  const std::string input = directory.file("scan.ply");
  generate("scan", 1'300'000, input, {.shuffle = true});
  const Words options{"--cell", "0.02"};
  const std::string memory = smallest_memory(input, options);
  CHECK(noticed(directory, input, options + Words{"--memory", memory}) >= 3);
  CHECK(noticed(directory, input, options + Words{"--memory", memory, "--strict"}) >= 3);
}

}  // namespace winnow::test
