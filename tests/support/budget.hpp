// What a child may use.
#pragma once

#include "base/budget.hpp"
#include "support/simplified.hpp"

namespace winnow::test {

inline std::uint64_t bytes_of_size(const std::string& mebibytes) {
  return std::stoull(mebibytes) * mebibyte;
}

// The promise: --memory and 32 MiB, all pages of the process, mapped ones too.
inline void check_peak(const Run& run, const std::string& memory) {
  INFO(run.err);
  REQUIRE(run.code == 0);
  const std::uint64_t most = bytes_of_size(memory) + 32 * mebibyte;
  CHECK(run.peak_resident <= most);
  const std::uint64_t reported = run.json()["peak_memory_bytes"];
  CHECK(reported <= most);
  // wait4 also counts what the child was before it became the program; the report does not.
  CHECK(reported <= run.peak_resident + mebibyte);
  CHECK(reported > mebibyte);
}

// What the message asks for, asked again where only then shows what else is needed.
inline std::string enough_memory(const Words& arguments) {
  std::string memory = "8M";
  for (int tries = 0; tries < 4; ++tries) {
    const Run run = run_winnow(arguments + Words{"--memory", memory});
    INFO(joined(arguments) << " --memory " << memory << ": " << run.err);
    if (run.code == 0) return memory;
    REQUIRE(run.code == 4);
    const std::size_t at = run.err.find("--memory ") + 9;
    const std::string more = run.err.substr(at, run.err.find('M', at) + 1 - at);
    REQUIRE(bytes_of_size(more) > bytes_of_size(memory));
    memory = more;
  }
  FAIL("four times a larger budget was asked for");
  return memory;
}

// Runs `winnow simplify` on a file with this --memory, or with the smallest that works where it is
// "smallest".
inline Run check_budget(const Directory& directory, const std::string& input, const Words& options,
                        std::string memory) {
  if (memory == "smallest") memory = smallest_memory(input, options);
  INFO(input << " " << joined(options) << " --memory " << memory);
  const std::string output = directory.file("out.ply");
  Run run =
      run_winnow(Words{"simplify", input, "-o", output, "--json", "--memory", memory} + options);
  check_peak(run, memory);
  ::unlink(output.c_str());
  return run;
}

}  // namespace winnow::test
