// Runs of `winnow simplify` whose outputs are compared.
#pragma once

#include "base/vector.hpp"
#include "support/files.hpp"
#include "support/program.hpp"

#include <string>
#include <utility>
#include <vector>

#include <catch2/catch.hpp>
#include <unistd.h>

namespace winnow::test {

using Words = std::vector<std::string>;

// Else the one below would hide that of positions.
using winnow::operator+;

inline Words operator+(Words words, const Words& more) {
  words.insert(words.end(), more.begin(), more.end());
  return words;
}

inline std::string joined(const Words& words) {
  std::string line;
  for (const std::string& word : words) line += (line.empty() ? "" : " ") + word;
  return line;
}

// The hash of the mesh, and the report without names of files.
struct Simplified {
  std::string hash;
  nlohmann::json report;
};

inline Simplified simplified_by(const Run& run, const std::string& output) {
  Simplified result{hash_of_file(output), run.json()};
  result.report["input"].erase("files");
  result.report["output"].erase("file");
  ::unlink(output.c_str());
  return result;
}

// `winnow simplify input -o out.<format>` in `directory`; the output is removed again.
inline Simplified simplified(const Directory& directory, const std::string& input,
                             const Words& options, const Setup& setup = {},
                             const std::string& output = "out.ply") {
  const std::string path = directory.file(output);
  return simplified_by(winnow_ok(Words{"simplify", input, "-o", path, "--json"} + options, setup),
                       path);
}

// The same through a pipe.
inline Simplified simplified_by_pipe(const Directory& directory, const std::string& input,
                                     const Words& options) {
  const std::string output = directory.file("piped.ply");
  Program program(Words{"simplify", "-", "-o", output, "--json"} + options, {.in = "|"});
  CHECK(program.write(bytes_of_file(input)));
  const Run run = program.wait();
  INFO(run.err);
  REQUIRE(run.code == 0);
  return simplified_by(run, output);
}

// The --memory that the message of a run names which had too little.
inline std::string named_memory(const Run& run) {
  const std::string before = "the smallest that works is --memory ";
  const std::size_t at = run.err.find(before);
  INFO(run.err);
  REQUIRE(run.code == 4);
  REQUIRE(at != std::string::npos);
  const std::size_t begin = at + before.size();
  return run.err.substr(begin, run.err.find('M', begin) + 1 - begin);
}

// The smallest --memory that works for a command, by the message that a smaller one gets.
inline std::string smallest_memory_of(const Words& command, const std::string& too_small = "1M") {
  return named_memory(
      run_winnow(command + Words{"-o", "never-written.ply", "--memory", too_small}));
}
inline std::string smallest_memory(const std::string& input, const Words& options,
                                   const std::string& too_small = "1M") {
  return smallest_memory_of(Words{"simplify", input} + options, too_small);
}

}  // namespace winnow::test
