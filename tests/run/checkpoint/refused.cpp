// A checkpoint that cannot be used is one clear error that names the file and the way out; so is a
// directory that cannot be one.
#include "io/manifest.hpp"
#include "support/checkpoints.hpp"
#include "support/simplified.hpp"

#include <chrono>
#include <csignal>
#include <filesystem>
#include <thread>

#include <sys/stat.h>

namespace winnow::test {

namespace {

class Stopped {
 public:
  explicit Stopped(const std::string& stage = "refine") {
    generate("scan", 20'000, input);
    SimplifyOptions options;
    options.target = Target::faces(1'000);
    kept = stopped_at(directory, {input}, output, options, stage).directory;
  }

  [[nodiscard]] std::string file(const std::string& name) const { return kept + "/" + name; }

  // The run cannot be resumed, for this reason.
  void check_refused(const Words& parts, int code = 3) const {
    const Run run = run_winnow({"resume", kept});
    INFO(run.err);
    CHECK(run.code == code);
    for (const std::string& part : parts) CHECK(run.err.find(part) != std::string::npos);
    CHECK_FALSE(exists(output));
  }

  Directory directory;
  std::string input = directory.file("in.ply"), output = directory.file("out.ply"), kept;
};

void flip(const std::string& path, std::size_t byte) {
  std::string bytes = bytes_of_file(path);
  bytes.at(byte) = static_cast<char>(bytes.at(byte) ^ 4);
  write_file(path, bytes);
}

}  // namespace

TEST_CASE("a damaged checkpoint is refused and its file named", "[faults]") {
  const Stopped stopped;
  for (const char* name : {"manifest", "stage-0.vertices", "stage-0.faces"}) {
    const std::string path = stopped.file(name);
    const std::string bytes = bytes_of_file(path);
    for (const std::size_t byte : {std::size_t{0}, bytes.size() / 2, bytes.size() - 1}) {
      flip(path, byte);
      stopped.check_refused({"'" + path + "' is damaged", "run the command again"});
      write_file(path, bytes);
    }
    write_file(path, bytes.substr(0, bytes.size() - 1));
    stopped.check_refused({"'" + path + "' is damaged"});
    write_file(path, "");
    stopped.check_refused({"'" + path + "' is damaged"});
    write_file(path, bytes);
  }
  ::unlink(stopped.file("stage-0.faces").c_str());
  stopped.check_refused({"'" + stopped.file("stage-0.faces") + "' is damaged: it is missing"});
}

TEST_CASE("a checkpoint of another version is refused", "[faults]") {
  const Stopped stopped;
  const std::string path = stopped.file("manifest");
  Manifest manifest = Manifest::parse(bytes_of_file(path), path);
  manifest.set("version", std::string("99.0.0"));
  write_file(path, manifest.print());
  stopped.check_refused({stopped.kept, "99.0.0", "winnow simplify again"});
}

TEST_CASE("a checkpoint whose input has changed is refused", "[faults]") {
  for (const char* stage : {"refine", "weld"}) {
    const Stopped stopped(stage);
    flip(stopped.input, 5'000);
    stopped.check_refused({"'" + stopped.input + "' has changed", stopped.kept});
    ::unlink(stopped.input.c_str());
    if (std::string(stage) == "weld")
      stopped.check_refused({"'" + stopped.input + "'", "is not there"});
  }
}

TEST_CASE("a pipe that was not read to its end cannot be resumed", "[faults]") {
  const Directory directory;
  const std::string input = directory.file("in.ply");
  generate("scan", 2'000, input);
  const std::string kept = directory.file("kept");
  const Words arguments{"simplify", "-", "-o", directory.file("out.ply"), "--faces", "500"};
  Program program(arguments + Words{"--checkpoint", kept}, {.in = "|"});
  program.write(bytes_of_file(input).substr(0, 9'000));
  while (program.running() && !exists(kept + "/manifest"))
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  program.signal(SIGKILL);
  program.wait();
  const Run run = run_winnow({"resume", kept});
  INFO(run.err);
  CHECK(run.code == 3);
  CHECK(run.err.find("pipe") != std::string::npos);
  CHECK(run.err.find("remove '" + kept + "'") != std::string::npos);
}

TEST_CASE("a pipe that was read is needed no more", "[faults]") {
  const Directory directory;
  const std::string input = directory.file("in.ply");
  generate("scan", 160'000, input);
  const std::string kept = directory.file("kept");
  const std::string output = directory.file("out.ply");
  const Words options{"--faces", "5k", "--checkpoint", kept};
  const std::string want = simplified(directory, input, options).hash;
  Program program(Words{"simplify", "-", "-o", output} + options, {.in = input});
  while (program.running() && !exists(kept + "/stage-0.faces"))
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  std::this_thread::sleep_for(std::chrono::milliseconds(50));
  program.signal(SIGKILL);
  const Run killed = program.wait();
  if (killed.signal != SIGKILL || !exists(kept + "/manifest")) return;  // it was done already
  const Run run = run_winnow({"resume", kept, "--json"});
  if (run.code == 3) {  // the file was there, but not in the manifest yet
    CHECK(run.err.find("pipe") != std::string::npos);
    return;
  }
  INFO(run.err);
  REQUIRE(run.code == 0);
  CHECK(run.json()["resumed"]["clustered"] == true);
  CHECK(hash_of_file(output) == want);
}

TEST_CASE("two runs do not share a checkpoint", "[faults]") {
  const Directory directory;
  const std::string kept = directory.file("kept");
  const Words arguments{"simplify", "-",   "-o",           directory.file("out.ply"),
                        "--faces",  "500", "--checkpoint", kept};
  Program program(arguments, {.in = "|"});
  while (program.running() && !exists(kept + "/winnow-lock"))
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  std::this_thread::sleep_for(std::chrono::milliseconds(20));
  for (const Words& second : {Words{"resume", kept}, arguments}) {
    const Run run = run_winnow(second);
    INFO(run.err);
    CHECK(run.code == 4);
    CHECK(run.err.find("another run works in '" + kept + "'") != std::string::npos);
  }
  program.signal(SIGTERM);
  CHECK(program.wait().code == 130);
  CHECK(std::filesystem::is_empty(kept));
}

TEST_CASE("an output that came while the run was stopped is not replaced", "[faults]") {
  const Stopped stopped;
  write_file(stopped.output, "of somebody else");
  const Run run = run_winnow({"resume", stopped.kept});
  INFO(run.err);
  CHECK(run.code == 2);
  CHECK(run.err.find("'" + stopped.output + "' exists") != std::string::npos);
  CHECK(run.err.find("move it away and resume again") != std::string::npos);
  CHECK(bytes_of_file(stopped.output) == "of somebody else");
  ::unlink(stopped.output.c_str());
  winnow_ok({"resume", stopped.kept});
  CHECK(exists(stopped.output));
}

TEST_CASE("a directory that holds something else is no place for a checkpoint", "[faults]") {
  const Directory directory;
  const std::string input = directory.file("in.ply");
  generate("scan", 2'000, input);
  const auto refused = [&](const std::string& place, const std::string& part, int code) {
    const Run run = run_winnow({"simplify", input, "-o", directory.file("out.ply"), "--faces",
                                "500", "--checkpoint", place});
    INFO(run.err);
    CHECK(run.code == code);
    CHECK(run.err.find(part) != std::string::npos);
    CHECK_FALSE(exists(directory.file("out.ply")));
  };
  const Words before = directory.names();
  refused(directory.path(), "is not empty", 2);
  CHECK(directory.names() == before);
  refused(input, "'" + input + "' is no directory", 2);
  refused(directory.file("missing/kept"), "cannot be made one", 2);
  CHECK(bytes_of_file(input).substr(0, 3) == "ply");
  for (const std::string& place : {directory.path(), input, directory.file("missing")}) {
    const Run run = run_winnow({"resume", place});
    INFO(run.err);
    CHECK(run.code == 3);
    CHECK(run.err.find("'" + place + "'") != std::string::npos);
  }
  // That of another run.
  const Stopped stopped;
  const Run run = run_winnow({"simplify", input, "-o", directory.file("out.ply"), "--faces", "500",
                              "--checkpoint", stopped.kept});
  INFO(run.err);
  CHECK(run.code == 2);
  CHECK(run.err.find("winnow resume '" + stopped.kept + "'") != std::string::npos);
  winnow_ok({"resume", stopped.kept});
  CHECK(exists(stopped.output));
}

TEST_CASE("a run that fails before it has read anything leaves no checkpoint", "[faults]") {
  const Directory directory;
  const std::string kept = directory.file("kept");
  const Run run = run_winnow({"simplify", directory.file("missing.ply"), "-o",
                              directory.file("out.ply"), "--faces", "500", "--checkpoint", kept});
  CHECK(run.code == 3);
  CHECK(std::filesystem::is_empty(kept));
}

}  // namespace winnow::test
