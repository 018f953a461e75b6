// Scratch directories that cannot be used; scratch and outputs that a killed run left behind.
#include "support/simplified.hpp"

#include <chrono>
#include <csignal>
#include <iostream>
#include <thread>

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>

namespace winnow::test {

namespace {

const Words whole{"--cell", "0.0005", "--threads", "2"};

}  // namespace

TEST_CASE("a scratch directory that is not there is refused", "[faults]") {
  const Directory directory;
  const std::string input = directory.file("scan.ply");
  generate("scan", 2'000, input);
  for (const std::string& scratch : {directory.file("missing"), input}) {
    const Run run = run_winnow(
        {"simplify", input, "-o", directory.file("out.ply"), "--grid", "9", "--scratch", scratch});
    INFO(run.err);
    CHECK(run.code == 2);
    CHECK(run.err.find("'" + scratch + "' is not a directory") != std::string::npos);
  }
  CHECK(directory.names() == Words{"scan.ply"});
}

TEST_CASE("a scratch directory that may not be written to is refused when it is needed",
          "[faults]") {
  const Directory directory;
  ::chmod(directory.path().c_str(), 0777);
  const std::string input = directory.file("scan.ply");
  generate("scan", 400'000, input);
  const std::string closed = directory.file("closed");
  ::mkdir(closed.c_str(), 0555);
  const std::string output = directory.file("out.ply");
  const Words options = whole + Words{"--scratch", closed};
  const Run spills = run_winnow(
      Words{"simplify", input, "-o", output, "--memory", smallest_memory(input, whole)} + options,
      {.unprivileged = true});
  if (spills.code == 97) {
    std::cout << "skipped: another user may not run " << WINNOW_PROGRAM << "\n";
    return;
  }
  INFO(spills.err);
  CHECK(spills.code == 4);
  CHECK(spills.err.find("'" + closed + "'") != std::string::npos);
  CHECK(spills.err.find("--scratch") != std::string::npos);
  CHECK(directory.names() == Words{"closed", "scan.ply"});
  CHECK(run_winnow(Words{"simplify", input, "-o", output, "--memory", "2G"} + options,
                   {.unprivileged = true})
            .code == 0);
}

TEST_CASE("scratch that a dead run left is removed and that of a living one kept", "[faults]") {
  const Directory directory;
  const std::string input = directory.file("scan.ply");
  generate("scan", 400'000, input);
  const std::string stale = directory.file("winnow-scratch-Ab12Cd");
  const std::string alive = directory.file("winnow-scratch-Ef34Gh");
  const std::string other = directory.file("winnow-scratchpad");
  for (const std::string& file : {stale, alive, other}) write_file(file, "left behind");
  const int fd = ::open(alive.c_str(), O_RDONLY | O_CLOEXEC);
  REQUIRE(::flock(fd, LOCK_EX | LOCK_NB) == 0);
  winnow_ok(Words{"simplify", input, "-o", directory.file("out.ply"), "--memory",
                  smallest_memory(input, whole)} +
            whole);
  CHECK_FALSE(exists(stale));
  CHECK(exists(alive));
  CHECK(exists(other));
  ::close(fd);
}

TEST_CASE("a killed run leaves no scratch and what it left goes with the next", "[faults]") {
  const Directory directory;
  const Directory scratch;
  const std::string input = directory.file("scan.ply");
  generate("scan", 400'000, input);
  const Words arguments =
      Words{"simplify",  input,          "-o",       directory.file("out.ply"),
            "--scratch", scratch.path(), "--memory", smallest_memory(input, whole)} +
      whole;
  for (int i = 0; i < 4; ++i) {
    Program program(arguments);
    while (program.running() && directory.names().size() < 2)
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
    std::this_thread::sleep_for(std::chrono::milliseconds(60 * i));
    program.signal(SIGKILL);
    CHECK(program.wait().signal == SIGKILL);
    CHECK_FALSE(exists(directory.file("out.ply")));
    CHECK(scratch.names().empty());
  }
  winnow_ok(arguments);
  CHECK(directory.names() == Words{"out.ply", "scan.ply"});
}

}  // namespace winnow::test
