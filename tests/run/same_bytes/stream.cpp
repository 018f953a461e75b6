// File, redirection, pipe, gzip and zstd give the same bytes, and so does writing to a pipe.
#include "support/simplified.hpp"

namespace winnow::test {

namespace {

const std::vector<Words> all_resolutions{{"--cell", "0.02"},
                                         {"--grid", "70"},
                                         {"--faces", "5000", "--refine", "none"},
                                         {"--ratio", "20%", "--refine", "none"}};

nlohmann::json without_names(nlohmann::json part) {
  if (part.is_object()) part.erase("file"), part.erase("files");
  return part;
}

void compare_routes(const std::string& surface, const std::string& format) {
  const Directory directory;
  const std::string input = directory.file(surface + "." + format);
  generate(surface, 60'000, input);
  const std::string gzip = gzip_file(input);
  const std::string zstd = zstd_file(input);
  for (const Words& options : all_resolutions) {
    INFO(surface << "." << format << " " << joined(options));
    const Simplified file = simplified(directory, input, options);
    CHECK(simplified(directory, "-", options, {.in = input}).hash == file.hash);
    CHECK(simplified(directory, gzip, options).hash == file.hash);
    CHECK(simplified(directory, zstd, options).hash == file.hash);
    CHECK(simplified(directory, "-", options, {.in = zstd}).hash == file.hash);
    const Simplified piped = simplified_by_pipe(directory, input, options);
    CHECK(piped.hash == file.hash);
    CHECK(simplified_by_pipe(directory, gzip, options).hash == file.hash);
    for (const char* count :
         {"input", "output", "cells", "reoriented_faces", "merged_opposite_faces",
          "weight_clamped_faces", "cell_size", "cluster_passes", "notes"}) {
      INFO(count);
      CHECK(without_names(piped.report[count]) == without_names(file.report[count]));
    }
  }
}

}  // namespace

TEST_CASE("the same bytes from all of file pipe gzip zstd PLY", "[same_bytes]") {
  compare_routes("scan", "ply");
}
TEST_CASE("the same bytes from all of file pipe gzip zstd STL", "[same_bytes]") {
  compare_routes("part", "stl");
}

TEST_CASE("a pipe whose vertices do not fit into memory gives the same bytes", "[same_bytes]") {
  const Directory directory;
  const std::string input = directory.file("scan.ply");
  generate("scan", 1'600'000, input);
  const Words options{"--cell", "0.02", "--threads", "1"};
  const Simplified file = simplified(directory, input, options);
  const Simplified piped = simplified_by_pipe(
      directory, input, options + Words{"--memory", smallest_memory(input, options)});
  CHECK(file.report["spilled_bytes"] == 0);
  CHECK(piped.report["spilled_bytes"] > 0);
  CHECK(piped.hash == file.hash);
}

TEST_CASE("the same bytes to a file a redirected file and a pipe", "[same_bytes]") {
  const Directory directory;
  const std::string input = directory.file("terrain.ply");
  generate("terrain", 60'000, input);
  for (const char* format : {"ply", "stl"}) {
    const Words options{"--grid", "100", "--to", format};
    const std::string whole = directory.file("whole");
    winnow_ok(Words{"simplify", input, "-o", whole, "-q"} + options);
    const std::string redirected = directory.file("redirected");
    winnow_ok(Words{"simplify", input, "-o", "-", "-q"} + options, {.out = redirected});
    CHECK(hash_of_file(redirected) == hash_of_file(whole));
    Program program(Words{"simplify", input, "-o", "-", "-q"} + options, {.out = "|"});
    std::string bytes;
    for (std::string part = program.read(); !part.empty(); part = program.read()) bytes += part;
    CHECK(program.wait().code == 0);
    CHECK(bytes == bytes_of_file(whole));
    ::unlink(whole.c_str());
  }
}

}  // namespace winnow::test
