// A file cut anywhere ends in a documented way: an error that names it and leaves nothing behind,
// or, where a format cannot tell, a result with a note.
#include "support/simplified.hpp"

#include <algorithm>

namespace winnow::test {

namespace {

enum class Cut { refused, noted_or_refused };

// Cuts at every 512 bytes; every eighth comes through a pipe, too.
void check_cuts(const Directory& directory, const std::string& name, Cut expected) {
  const std::string whole = bytes_of_file(directory.file(name));
  const Directory place;
  const std::string cut = place.file("cut");
  const std::string output = place.file("out.ply");
  unsigned refused = 0;
  for (std::size_t length = 0; length < whole.size(); length += 512) {
    write_file(cut, whole.substr(0, length));
    const Words options{"-o", output, "--grid", "20", "--json", "--threads", "2"};
    std::vector<Run> runs{run_winnow(Words{"simplify", cut} + options)};
    if (length % 4096 == 0) {
      ::unlink(output.c_str());
      Program program(Words{"simplify", "-"} + options, {.in = "|"});
      program.write(whole.substr(0, length));
      runs.push_back(program.wait());
    }
    for (const Run& run : runs) {
      INFO(name << " cut at byte " << length << ": " << run.err);
      REQUIRE(run.signal == 0);
      if (run.code == 0) {
        CHECK(expected == Cut::noted_or_refused);
        CHECK_FALSE(run.json()["notes"].empty());
        continue;
      }
      ++refused;
      CHECK(run.code == 3);
      CHECK((run.err.find("'" + cut + "'") != std::string::npos ||
             run.err.find("'standard input'") != std::string::npos));
      CHECK(std::count(run.err.begin(), run.err.end(), '\n') == 1);
      CHECK(run.json()["error"]["exit_code"] == 3);
    }
    if (runs.back().code == 0) ::unlink(output.c_str());
    REQUIRE(place.names() == Words{"cut"});
  }
  CHECK(refused > 0);
}

}  // namespace

TEST_CASE("a binary PLY cut anywhere is refused", "[faults]") {
  const Directory directory;
  generate("scan", 2'000, directory.file("scan.ply"));
  check_cuts(directory, "scan.ply", Cut::refused);
}

TEST_CASE("an ASCII PLY cut anywhere is refused", "[faults]") {
  const Directory directory;
  generate("part", 1'000, directory.file("part.ply"));
  ascii_file(directory.file("part.ply"), directory.file("ascii.ply"));
  check_cuts(directory, "ascii.ply", Cut::refused);
}

TEST_CASE("a binary STL cut anywhere is refused or noted", "[faults]") {
  const Directory directory;
  generate("scan", 1'000, directory.file("scan.stl"));
  check_cuts(directory, "scan.stl", Cut::noted_or_refused);
}

TEST_CASE("an ASCII STL cut anywhere is refused", "[faults]") {
  const Directory directory;
  generate("terrain", 200, directory.file("terrain.stl"));
  ascii_file(directory.file("terrain.stl"), directory.file("ascii.stl"));
  check_cuts(directory, "ascii.stl", Cut::noted_or_refused);
}

TEST_CASE("compressed content cut anywhere is refused", "[faults]") {
  const Directory directory;
  generate("scan", 2'000, directory.file("scan.ply"));
  generate("scan", 1'000, directory.file("scan.stl"));
  for (const char* name : {"scan.ply", "scan.stl"}) {
    gzip_file(directory.file(name));
    zstd_file(directory.file(name));
    check_cuts(directory, std::string(name) + ".gz", Cut::refused);
    check_cuts(directory, std::string(name) + ".zst", Cut::refused);
  }
}

}  // namespace winnow::test
