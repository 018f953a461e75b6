// Several results of one run: no byte depends on threads, memory, or a pipe.
#include "support/simplified.hpp"

namespace winnow::test {

TEST_CASE("the same levels with other threads, little memory, and through a pipe", "[same_bytes]") {
  const Directory directory;
  const std::string input = directory.file("scan.ply");
  const std::string output = directory.file("level-{faces}.ply");
  generate("scan", 300'000, input);
  const Words options{"--faces", "600,60k,9k", "--detail", "full"};
  const auto hashes = [&](const Run& run) {
    Words all;
    const nlohmann::json report = run.json();
    for (const auto& level : report["levels"]) {
      const std::string file = level["output"]["file"];
      all.push_back(hash_of_file(file));
      ::unlink(file.c_str());
    }
    CHECK(all.size() == 3);
    return all;
  };
  const Words arguments = Words{"simplify", input, "-o", output, "--json"} + options;
  const Words want = hashes(winnow_ok(arguments + Words{"--threads", "1"}));
  CHECK(hashes(winnow_ok(arguments + Words{"--threads", "4"})) == want);
  const std::string memory = smallest_memory(input, {"--faces", "600", "--detail", "full"});
  const Run small = winnow_ok(arguments + Words{"--threads", "2", "--memory", memory});
  CHECK(small.json()["spilled_bytes"] > 0);
  CHECK(hashes(small) == want);
  Program program(Words{"simplify", "-", "-o", output, "--json"} + options, {.in = "|"});
  CHECK(program.write(bytes_of_file(input)));
  const Run piped = program.wait();
  INFO(piped.err);
  REQUIRE(piped.code == 0);
  CHECK(hashes(piped) == want);
}

}  // namespace winnow::test
