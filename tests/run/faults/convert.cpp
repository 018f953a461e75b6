// A conversion that is interrupted, or runs out of disk, says so and leaves nothing under the
// output's name.
#include "support/simplified.hpp"

#include <csignal>

namespace winnow::test {

namespace {

void check_nothing_left(const Directory& directory, const Run& run, int code) {
  INFO(run.err);
  CHECK(run.code == code);
  CHECK(directory.names() == std::vector<std::string>{"scan.ply"});
}

}  // namespace

TEST_CASE("a conversion that is interrupted leaves nothing", "[faults]") {
  const Directory directory;
  generate("scan", 2'000, directory.file("scan.ply"));
  for (const char* output : {"out.glb", "out.ply.zst"}) {
    Program program({"convert", "-", "-o", directory.file(output), "-q"}, {.in = "|"});
    program.write(bytes_of_file(directory.file("scan.ply")).substr(0, 20'000));
    program.await_handlers();
    program.signal(SIGINT);
    const Run run = program.wait();
    CHECK(run.seconds < 2);
    check_nothing_left(directory, run, 130);
  }
}

TEST_CASE("a conversion onto a full disk leaves nothing", "[faults]") {
  const Directory directory;
  generate("scan", 40'000, directory.file("scan.ply"));
  for (const char* output : {"out.stl", "out.ply.gz", "out.glb"}) {
    const Run run =
        run_winnow({"convert", directory.file("scan.ply"), "-o", directory.file(output), "-q"},
                   {.largest_file = 200'000});
    check_nothing_left(directory, run, 4);
    CHECK(run.err.find("free some space") != std::string::npos);
  }
}

TEST_CASE("an input that ends inside its faces is named, and nothing is written", "[faults]") {
  const Directory directory;
  generate("scan", 2'000, directory.file("scan.ply"));
  const std::string whole = bytes_of_file(directory.file("scan.ply"));
  write_file(directory.file("scan.ply"), whole.substr(0, whole.size() - 100));
  const Run run =
      run_winnow({"convert", directory.file("scan.ply"), "-o", directory.file("out.glb"), "-q"});
  check_nothing_left(directory, run, 3);
  CHECK(run.err.find("scan.ply") != std::string::npos);
}

}  // namespace winnow::test
