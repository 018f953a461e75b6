// SIGINT and SIGTERM stop within a second wherever the program is, leave no output, nothing beside
// it and no scratch, and end with 130.
#include "support/simplified.hpp"

#include <chrono>
#include <csignal>
#include <random>
#include <thread>

#include <sys/stat.h>

namespace winnow::test {

namespace {

void sleep_for(double seconds) {
  std::this_thread::sleep_for(std::chrono::duration<double>(seconds));
}

void check_stopped(const Run& run) {
  INFO(run.err);
  CHECK(run.signal == 0);
  CHECK(run.code == 130);
  CHECK(run.seconds < 1 * patience);
  CHECK(run.out.empty());
}

// Stops `arguments` at many moments of its life, of which the first run tells the length.
void check_random_moments(const Directory& directory, const Words& arguments, int tries,
                          const Setup& setup = {}) {
  const Words before = directory.names();
  const Run whole = winnow_ok(arguments, setup);
  ::unlink(directory.file("out.ply").c_str());
  REQUIRE(directory.names() == before);
  std::mt19937 random(1);
  int stopped = 0;
  for (int i = 0; i < tries; ++i) {
    Program program(arguments, setup);
    program.await_handlers();
    const double moment =
        whole.seconds * (i + std::uniform_real_distribution(0.0, 1.0)(random)) / tries;
    sleep_for(moment);
    program.signal(i % 2 == 0 ? SIGINT : SIGTERM);
    const Run run = program.wait();
    INFO(joined(arguments) << "\nstopped after " << moment << " of " << whole.seconds
                           << " s: " << run.err);
    CHECK(run.seconds < 1 * patience);
    if (run.code == 0) {  // too late
      ::unlink(directory.file("out.ply").c_str());
    } else {
      ++stopped;
      check_stopped(run);
    }
    REQUIRE(directory.names() == before);
  }
  CHECK(stopped > tries / 3);
}

}  // namespace

TEST_CASE("a run that spills is stopped at any moment", "[faults]") {
  const Directory directory;
  const std::string input = directory.file("scan.ply");
  generate("scan", 300'000, input);
  const Words options{"--cell", "0.001", "--threads", "2", "--placement", "quadric"};
  check_random_moments(directory,
                       Words{"simplify", input, "-o", directory.file("out.ply"), "--memory",
                             smallest_memory(input, options)} +
                           options,
                       14);
}

TEST_CASE("a run that samples a compressed stream is stopped at any moment", "[faults]") {
  const Directory directory;
  const std::string input = directory.file("scan.stl");
  generate("scan", 400'000, input);
  check_random_moments(directory,
                       {"simplify", gzip_file(input), "-o", directory.file("out.ply"), "--faces",
                        "100k", "--refine", "none"},
                       10);
}

TEST_CASE("generating is stopped at any moment", "[faults]") {
  const Directory directory;
  check_random_moments(
      directory, {"generate", "terrain", "--faces", "1500k", "-o", directory.file("out.ply")}, 6);
}

TEST_CASE("waiting for a silent pipe is stopped", "[faults]") {
  const Directory directory;
  const std::string input = directory.file("scan.ply");
  generate("scan", 20'000, input);
  const std::string bytes = bytes_of_file(input);
  for (const std::string& how :
       {std::string("--cell"), std::string("--grid"), std::string("--faces")}) {
    // Before the first byte, in the header, among the vertices, among the faces.
    for (const std::size_t sent :
         {std::size_t{0}, std::size_t{50}, std::size_t{9'000}, bytes.size() - 1000}) {
      INFO(how << " " << sent << " bytes sent");
      Program program(
          {"simplify", "-", "-o", directory.file("out.ply"), how, how == "--cell" ? "0.1" : "50"},
          {.in = "|"});
      program.write(bytes.substr(0, sent));
      program.await_handlers();
      sleep_for(0.05);
      program.signal(sent == 0 ? SIGTERM : SIGINT);
      // The pipe stays open: it is the signal that ends the wait.
      while (program.running()) sleep_for(0.001);
      check_stopped(program.wait());
      CHECK(directory.names() == Words{"scan.ply"});
    }
  }
}

TEST_CASE("waiting for a reader that sleeps is stopped", "[faults]") {
  const Directory directory;
  const std::string input = directory.file("scan.ply");
  generate("scan", 100'000, input);
  for (const Words& arguments : {Words{"simplify", input, "-o", "-", "--cell", "0.001"},
                                 Words{"generate", "scan", "-o", "-"}}) {
    Program program(arguments, {.out = "|"});
    CHECK_FALSE(program.read(1).empty());  // it writes
    sleep_for(0.1);                        // the pipe is full
    program.signal(SIGINT);
    while (program.running()) sleep_for(0.001);
    const Run run = program.wait();
    INFO(joined(arguments) << ": " << run.err);
    CHECK(run.code == 130);
    CHECK(run.seconds < 1 * patience);
  }
}

TEST_CASE("waiting for the other end of a named pipe is stopped", "[faults]") {
  const Directory directory;
  const std::string input = directory.file("scan.ply");
  generate("scan", 2'000, input);
  const std::string pipe = directory.file("pipe");
  REQUIRE(::mkfifo(pipe.c_str(), 0600) == 0);
  const Words before = directory.names();
  for (const Words& arguments :
       {Words{"simplify", pipe, "-o", directory.file("out.ply"), "--cell", "0.1"},
        Words{"simplify", input, "-o", pipe, "--cell", "0.1"}}) {
    Program program(arguments);
    program.await_handlers();
    sleep_for(0.1);
    REQUIRE(program.running());
    program.signal(SIGINT);
    INFO(joined(arguments));
    check_stopped(program.wait(5));
    CHECK(directory.names() == before);
  }
}

TEST_CASE("every signal that ends a program leaves no part of an output", "[faults]") {
  const Directory directory;
  const std::string input = directory.file("scan.ply");
  generate("scan", 2'000, input);
  const std::string bytes = bytes_of_file(input);
  for (const int number : {SIGINT, SIGTERM, SIGHUP, SIGQUIT, SIGXCPU, SIGALRM, SIGVTALRM, SIGPROF,
                           SIGUSR1, SIGUSR2, SIGIO, SIGPWR}) {
    Program program({"simplify", "-", "-o", directory.file("out.ply"), "--cell", "0.1"},
                    {.in = "|"});
    program.write(bytes.substr(0, 1000));
    program.await_handlers();
    while (program.running() && directory.names().size() < 2) sleep_for(0.001);
    program.signal(number);
    while (program.running()) sleep_for(0.001);
    INFO(number);
    check_stopped(program.wait());
    CHECK(directory.names() == Words{"scan.ply"});
  }
}

TEST_CASE("a second signal does no harm", "[faults]") {
  const Directory directory;
  const std::string input = directory.file("scan.ply");
  generate("scan", 500'000, input);
  Program program({"simplify", input, "-o", directory.file("out.ply"), "--cell", "0.001"});
  program.await_handlers();
  sleep_for(0.05);
  for (int i = 0; i < 20; ++i) ::kill(program.pid(), i % 2 == 0 ? SIGINT : SIGTERM);
  program.signal(SIGINT);
  check_stopped(program.wait());
  CHECK(directory.names() == Words{"scan.ply"});
}

}  // namespace winnow::test
