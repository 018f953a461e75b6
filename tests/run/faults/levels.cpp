// The files of several results appear together, or none of them does.
#include "support/runnable.hpp"
#include "support/simplified.hpp"

#include <cerrno>
#include <filesystem>

namespace winnow::test {

TEST_CASE("where one of several outputs cannot appear none does", "[faults]") {
  const Directory directory;
  const std::string input = directory.file("in.ply");
  generate("scan", 30'000, input);
  const Words arguments{"simplify", input,     "-o", directory.file("level-{faces}.ply"),
                        "--faces",  "9k,3k,1k"};
  const Words names{"level-1000.ply", "level-3000.ply", "level-9000.ply"};
  const Words before = directory.names();
  for (const std::string& name : names) {
    for (const char* call : {"rename", "sync", "write"}) {
      const std::string file = std::string(call) == "rename" ? name : "." + name + ".winnow-";
      const std::string fault = std::string(call) + " 1 " + std::to_string(EIO) + " " + file;
      INFO(fault);
      const Run run = run_winnow(arguments, {.fault = fault});
      CHECK(run.code == 4);
      CHECK(run.err.find(name) != std::string::npos);
      CHECK(directory.names() == before);
    }
  }
  for (const std::string& name : names) write_file(directory.file(name), "precious " + name);
  for (const std::string& name : names) {
    const std::string fault = "rename 1 " + std::to_string(EIO) + " " + name;
    INFO(fault);
    CHECK(run_winnow(arguments + Words{"--force"}, {.fault = fault}).code == 4);
    for (const std::string& kept : names)
      CHECK(bytes_of_file(directory.file(kept)) == "precious " + kept);
  }
  CHECK(directory.names().size() == before.size() + names.size());
  winnow_ok(arguments + Words{"--force"});
  CHECK(directory.names().size() == before.size() + names.size());
  for (const std::string& name : names) CHECK(bytes_of_file(directory.file(name)).size() > 1000);
}

TEST_CASE("a run that could not name its outputs is resumed", "[faults]") {
  const Directory directory;
  const std::string input = directory.file("in.ply"), kept = directory.file("kept");
  generate("scan", 30'000, input);
  const Words levels{"-o", directory.file("level-{faces}.ply"), "--faces", "9k,3k,1k"};
  const Words arguments = Words{"simplify", input} + levels;
  const Words outputs{directory.file("level-9000.ply"), directory.file("level-3000.ply"),
                      directory.file("level-1000.ply")};
  winnow_ok(arguments);
  Words want;
  for (const std::string& output : outputs) {
    want.push_back(hash_of_file(output));
    ::unlink(output.c_str());
  }
  const std::string fault = "rename 1 " + std::to_string(EIO) + " level-3000.ply";
  CHECK(run_winnow(arguments + Words{"--checkpoint", kept}, {.fault = fault}).code == 4);
  for (const std::string& output : outputs) CHECK_FALSE(exists(output));
  CHECK(run_winnow({"resume", kept}, {.fault = fault}).code == 4);
  const Run run = winnow_ok({"resume", kept, "--json"});
  CHECK(run.json()["levels"].size() == 3);
  for (std::size_t i = 0; i < outputs.size(); ++i) CHECK(hash_of_file(outputs[i]) == want[i]);
  CHECK(std::filesystem::is_empty(kept));
}

TEST_CASE("one of several outputs that exists is refused before anything is read", "[faults]") {
  const Directory directory;
  write_file(directory.file("level-100.ply"), "precious");
  const Run run =
      run_winnow({"simplify", "-", "-o", directory.file("level-{faces}.ply"), "--faces", "1k,100"});
  CHECK(run.code == 2);
  CHECK(run.err.find("level-100.ply' exists") != std::string::npos);
  CHECK(directory.names() == Words{"level-100.ply"});
}

}  // namespace winnow::test
