// Whatever call to the system fails, the program ends with one clear message and its exit code, and
// nothing half-written stands under the output's name.
#include "support/simplified.hpp"

#include <cerrno>
#include <csignal>
#include <filesystem>

namespace winnow::test {

namespace {

std::string failing(const std::string& call, int number, int error, const std::string& part) {
  return call + " " + std::to_string(number) + " " + std::to_string(error) + " " + part;
}

// One line of message that has these parts.
void check_failed(const Run& run, int code, const Words& parts) {
  INFO(run.err);
  CHECK(run.signal == 0);
  CHECK(run.code == code);
  CHECK(std::count(run.err.begin(), run.err.end(), '\n') == 1);
  for (const std::string& part : parts) CHECK(run.err.find(part) != std::string::npos);
}

}  // namespace

TEST_CASE("an output that cannot be brought to the disk is refused", "[faults]") {
  const Directory directory;
  const std::string input = directory.file("in.ply");
  const std::string output = directory.file("out.ply");
  generate("scan", 30'000, input);
  const Words arguments{"simplify", input, "-o", output, "--cell", "0.001"};
  const std::string aside = ".out.ply.winnow-";
  for (const std::string& fault :
       {failing("write", 1, ENOSPC, aside), failing("write", 3, EIO, aside),
        failing("sync", 1, ENOSPC, aside), failing("sync", 1, EIO, aside),
        failing("close", 1, EDQUOT, aside), failing("rename", 1, EIO, "out.ply")}) {
    INFO(fault);
    check_failed(run_winnow(arguments, {.fault = fault}), 4, {"cannot write '" + output + "'"});
    CHECK(directory.names() == Words{"in.ply"});
    write_file(output, "precious");
    check_failed(run_winnow(arguments + Words{"--force"}, {.fault = fault}), 4, {output});
    CHECK(bytes_of_file(output) == "precious");
    ::unlink(output.c_str());
    CHECK(directory.names() == Words{"in.ply"});
  }
}

TEST_CASE("an input that cannot be read to its end is refused", "[faults]") {
  const Directory directory;
  const std::string plain = directory.file("in.ply");
  generate("scan", 100'000, plain);
  const std::string packed = zstd_file(plain);
  const std::string zipped = gzip_file(plain);
  const Words before = directory.names();
  for (const std::string& input : {plain, packed, zipped}) {
    for (const int number : {1, 2, 3}) {
      if (input == plain && number > 1) continue;  // the rest is mapped
      check_failed(
          run_winnow({"simplify", input, "-o", directory.file("out.ply"), "--faces", "500"},
                     {.fault = failing("read", number, EIO, input)}),
          3, {"cannot read '" + input + "' at byte", "Input/output error"});
    }
  }
  CHECK(directory.names() == before);
}

TEST_CASE("scratch that cannot be written or read back is refused", "[faults]") {
  const Directory directory;
  const std::string input = directory.file("in.ply");
  generate("scan", 400'000, input);
  const Words options{"--cell", "0.0005", "--threads", "2"};
  const Words arguments = Words{"simplify", input,
                                "-o",       directory.file("out.ply"),
                                "--memory", smallest_memory(input, options)} +
                          options;
  const std::string nameless = "/#";
  check_failed(run_winnow(arguments, {.fault = failing("write", 5, ENOSPC, nameless)}), 4,
               {"cannot write scratch in", directory.path(), "--scratch"});
  check_failed(run_winnow(arguments, {.fault = failing("read", 5, EIO, nameless)}), 4,
               {"cannot read scratch in", directory.path(), "Input/output error"});
  CHECK(directory.names() == Words{"in.ply"});
}

TEST_CASE("a checkpoint that cannot be written is an error, and no run is lost", "[faults]") {
  const Directory directory;
  const std::string input = directory.file("in.ply");
  const std::string output = directory.file("out.ply");
  const std::string kept = directory.file("kept");
  generate("scan", 160'000, input);
  const Words arguments{"simplify", input, "-o", output, "--faces", "5k", "--checkpoint", kept};
  winnow_ok(arguments);
  const std::string want = hash_of_file(output);
  ::unlink(output.c_str());
  for (const std::string& fault :
       {failing("write", 1, ENOSPC, "kept/manifest"), failing("rename", 2, EIO, "kept/manifest"),
        failing("sync", 4, EIO, "kept"), failing("write", 1, ENOSPC, "kept/stage-0"),
        failing("write", 4, ENOSPC, "kept/round-1"), failing("write", 1, ENOSPC, "kept/stage-2")}) {
    INFO(fault);
    check_failed(run_winnow(arguments, {.fault = fault}), 4, {kept});
    CHECK_FALSE(exists(output));
    const bool goes_on = exists(kept + "/manifest");
    CHECK(goes_on != std::filesystem::is_empty(kept));
    winnow_ok(goes_on ? Words{"resume", kept} : arguments);
    CHECK(hash_of_file(output) == want);
    ::unlink(output.c_str());
    CHECK(std::filesystem::is_empty(kept));
  }
}

TEST_CASE("a run killed before any call that changes the disk goes on to the same bytes",
          "[faults]") {
  const Directory directory;
  const std::string input = directory.file("in.ply");
  const std::string output = directory.file("out.ply");
  const std::string kept = directory.file("kept");
  generate("scan", 3'000, input);
  const Words arguments{"simplify", input,          "-o", output,      "--faces",
                        "500",      "--checkpoint", kept, "--threads", "2"};
  winnow_ok(arguments);
  const std::string want = hash_of_file(output);
  ::unlink(output.c_str());
  int number = 1;
  for (;; ++number) {
    INFO(number);
    Run run = run_winnow(arguments, {.fault = failing("change", number, 0, directory.path())});
    if (run.signal != SIGKILL) {
      CHECK(run.code == 0);
      break;
    }
    // Killed again, somewhere else.
    if (exists(kept + "/manifest"))
      run = run_winnow({"resume", kept},
                       {.fault = failing("change", 1 + number * 7 % 11, 0, directory.path())});
    if (exists(output)) CHECK(hash_of_file(output) == want);
    if (exists(kept + "/manifest")) {
      winnow_ok({"resume", kept});
    } else if (!exists(output)) {
      winnow_ok(arguments);
    }
    CHECK(hash_of_file(output) == want);
    ::unlink(output.c_str());
    for (const std::string& name : directory.names()) CHECK((name == "in.ply" || name == "kept"));
    std::filesystem::remove_all(kept);
  }
  CHECK(number > 30);  // that many such calls there are at least
}

TEST_CASE("a run that was killed when its output had its name is not done twice", "[faults]") {
  const Directory directory;
  const std::string input = directory.file("in.ply");
  const std::string mesh = directory.file("mesh.ply");
  const std::string kept = directory.file("kept");
  const std::string away = directory.file("away.ply");
  generate("scan", 3'000, input);
  const Words arguments{"simplify", input,          "-o", mesh,        "--faces", "500",
                        "--force",  "--checkpoint", kept, "--threads", "2"};
  winnow_ok(arguments);
  const std::string want = hash_of_file(mesh);
  int after = 0;  // killed when the output had its name
  for (int number = 1;; ++number) {
    INFO(number);
    // What is replaced.
    std::filesystem::copy_file(input, mesh, std::filesystem::copy_options::overwrite_existing);
    const Run run =
        run_winnow(arguments, {.fault = failing("change", number, 0, directory.path())});
    if (run.signal != SIGKILL) break;
    if (!exists(kept + "/manifest")) {
      if (hash_of_file(mesh) != want) winnow_ok(arguments);
    } else if (hash_of_file(mesh) != want) {
      winnow_ok({"resume", kept});
    } else {
      // Nothing is to be done again, so the input is not missed.
      ++after;
      std::filesystem::rename(input, away);
      winnow_ok({"resume", kept});
      std::filesystem::rename(away, input);
    }
    CHECK(hash_of_file(mesh) == want);
    std::filesystem::remove_all(kept);
  }
  CHECK(after > 1);
}

TEST_CASE("where no thread can be made, that is what is said", "[faults]") {
  const Directory directory;
  const std::string input = directory.file("in.ply");
  generate("scan", 30'000, input);
  const std::string output = directory.file("out.ply");
  for (const Words& arguments :
       {Words{"simplify", input, "-o", output, "--faces", "500"},
        Words{"convert", input, "-o", output}, Words{"info", input}, Words{"compare", input, input},
        Words{"generate", "scan", "-o", output}}) {
    INFO(joined(arguments));
    check_failed(run_winnow(arguments + Words{"--threads", "4"},
                            {.fault = failing("thread", 1, EAGAIN, "")}),
                 4, {"--threads 1"});
    CHECK(directory.names() == Words{"in.ply"});
  }
}

}  // namespace winnow::test
