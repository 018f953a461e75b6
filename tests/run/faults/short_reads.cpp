// A pipe that hands over a byte at a time, or a few, gives the same bytes as a file.
#include "support/simplified.hpp"

#include <chrono>
#include <thread>

namespace winnow::test {

namespace {

std::string through_slow_pipe(const Directory& directory, const std::string& bytes,
                              std::size_t (*next)(std::size_t)) {
  const std::string output = directory.file("piped.ply");
  Program program({"simplify", "-", "-o", output, "--cell", "0.1", "-q"}, {.in = "|"});
  for (std::size_t at = 0, chunk = 1; at < bytes.size(); at += chunk, chunk = next(chunk)) {
    if (!program.write(bytes.substr(at, chunk))) break;
  }
  const Run run = program.wait();
  INFO(run.err);
  REQUIRE(run.code == 0);
  const std::string hash = hash_of_file(output);
  ::unlink(output.c_str());
  return hash;
}

}  // namespace

TEST_CASE("a pipe of single bytes or odd chunks gives the same bytes", "[faults]") {
  const Directory directory;
  generate("scan", 600, directory.file("a.ply"));
  generate("scan", 300, directory.file("a.stl"));
  ascii_file(directory.file("a.ply"), directory.file("ascii.ply"));
  ascii_file(directory.file("a.stl"), directory.file("ascii.stl"));
  gzip_file(directory.file("a.ply"));
  zstd_file(directory.file("a.ply"));
  for (const char* name : {"a.ply", "a.stl", "ascii.ply", "ascii.stl", "a.ply.gz", "a.ply.zst"}) {
    INFO(name);
    const std::string bytes = bytes_of_file(directory.file(name));
    const std::string want = simplified(directory, directory.file(name), {"--cell", "0.1"}).hash;
    CHECK(through_slow_pipe(directory, bytes, [](std::size_t) -> std::size_t { return 1; }) ==
          want);
    CHECK(through_slow_pipe(directory, bytes, [](std::size_t last) { return last * 5 % 4099; }) ==
          want);
  }
}

TEST_CASE("a writer that pauses is waited for", "[faults]") {
  const Directory directory;
  const std::string input = directory.file("a.ply");
  generate("scan", 600, input);
  const std::string bytes = bytes_of_file(input);
  const std::string output = directory.file("out.ply");
  Program program({"simplify", "-", "-o", output, "--cell", "0.1", "-q"}, {.in = "|"});
  // In the magic, in the header, among vertices, among faces.
  std::size_t at = 0;
  for (const std::size_t end :
       {std::size_t{2}, std::size_t{100}, std::size_t{3000}, bytes.size() - 5, bytes.size()}) {
    CHECK(program.write(bytes.substr(at, end - at)));
    at = end;
    std::this_thread::sleep_for(std::chrono::milliseconds(150));
    CHECK(program.running());
  }
  CHECK(program.wait().code == 0);
  CHECK(hash_of_file(output) ==
        simplified(directory, input, {"--cell", "0.1"}, {}, "again.ply").hash);
}

}  // namespace winnow::test
