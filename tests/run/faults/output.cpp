// Outputs that are there, that cannot be, and that are no files.
#include "support/simplified.hpp"

#include <chrono>
#include <filesystem>
#include <iostream>
#include <thread>

#include <fcntl.h>
#include <sys/stat.h>

namespace winnow::test {

namespace {

struct Input {
  Directory directory;
  std::string path = directory.file("scan.ply");
  std::string hash;  // of the plain result
  Words options{"--grid", "40"};

  Input() {
    generate("scan", 20'000, path);
    hash = simplified(directory, path, options).hash;
  }
  [[nodiscard]] Run simplify_to(const std::string& output, const Words& more = {},
                                const Setup& setup = {}) const {
    return run_winnow(Words{"simplify", path, "-o", output} + options + more, setup);
  }
};

}  // namespace

TEST_CASE("an output that exists is left alone", "[faults]") {
  const Input input;
  const std::string output = input.directory.file("out.ply");
  write_file(output, "precious");
  // At once: also before an input is looked for.
  for (const std::string& from : {input.path, std::string("missing.ply")}) {
    const Run run = run_winnow({"simplify", from, "-o", output, "--grid", "40"});
    INFO(run.err);
    CHECK(run.code == 2);
    CHECK(run.err == "winnow: '" + output + "' exists; use --force to replace it\n");
    CHECK(bytes_of_file(output) == "precious");
  }
  CHECK(run_winnow({"generate", "scan", "-o", output}).code == 2);
  CHECK(bytes_of_file(output) == "precious");
  // A run with --force that fails leaves it, too.
  CHECK(run_winnow({"simplify", "missing.ply", "-o", output, "--grid", "40", "--force"}).code == 3);
  CHECK(bytes_of_file(output) == "precious");
  // One that succeeds replaces it, and keeps who may read it.
  ::chmod(output.c_str(), 0640);
  CHECK(input.simplify_to(output, {"--force"}).code == 0);
  CHECK(hash_of_file(output) == input.hash);
  struct stat status {};
  REQUIRE(::stat(output.c_str(), &status) == 0);
  CHECK((status.st_mode & 07777) == 0640);
  CHECK(input.directory.names() == Words{"out.ply", "scan.ply"});
}

TEST_CASE("an output that appears while the program runs is left alone", "[faults]") {
  const Input input;
  const std::string output = input.directory.file("out.ply");
  Program program({"simplify", "-", "-o", output, "--cell", "0.1"}, {.in = "|"});
  const std::string bytes = bytes_of_file(input.path);
  program.write(bytes.substr(0, 1000));
  // It has said that it may write there by now.
  while (program.running() && input.directory.names().size() < 2)
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  write_file(output, "precious");
  program.write(bytes.substr(1000));
  CHECK(program.wait().code == 2);
  CHECK(bytes_of_file(output) == "precious");
  CHECK(input.directory.names() == Words{"out.ply", "scan.ply"});
}

TEST_CASE("a new output is readable as any new file is", "[faults]") {
  const Input input;
  const std::string output = input.directory.file("out.ply");
  REQUIRE(input.simplify_to(output).code == 0);
  write_file(input.directory.file("other"), "");
  struct stat mesh {};
  struct stat other {};
  REQUIRE(::stat(output.c_str(), &mesh) == 0);
  REQUIRE(::stat(input.directory.file("other").c_str(), &other) == 0);
  CHECK(mesh.st_mode == other.st_mode);
}

TEST_CASE("an output that cannot be made is refused and named", "[faults]") {
  const Input input;
  const std::string nowhere = input.directory.file("missing/out.ply");
  const Run missing = input.simplify_to(nowhere);
  INFO(missing.err);
  CHECK(missing.code == 4);
  CHECK(missing.err.find("'" + nowhere + "'") != std::string::npos);
  const Run folder = input.simplify_to(input.directory.path());
  CHECK(folder.code == 2);
  CHECK(folder.err.find("is a directory") != std::string::npos);
  const Run inside = input.simplify_to(input.path + "/out.ply");
  CHECK(inside.code == 4);
  const Run nameless = input.simplify_to("");
  INFO(nameless.err);
  CHECK(nameless.code == 2);
  CHECK(input.directory.names() == Words{"scan.ply"});
}

TEST_CASE("a directory that may not be written to is refused", "[faults]") {
  const Input input;
  ::chmod(input.directory.path().c_str(), 0755);
  const std::string closed = input.directory.file("closed");
  ::mkdir(closed.c_str(), 0555);
  const Run run = input.simplify_to(closed + "/out.ply", {}, {.unprivileged = true});
  if (run.code == 97) {
    std::cout << "skipped: another user may not run " << WINNOW_PROGRAM << "\n";
    return;
  }
  INFO(run.err);
  CHECK(run.code == 4);
  CHECK(run.err.find("'" + closed + "/out.ply'") != std::string::npos);
  CHECK(std::filesystem::is_empty(closed));
}

TEST_CASE("devices are written straight and need no force", "[faults]") {
  const Input input;
  const Run null = input.simplify_to("/dev/null");
  INFO(null.err);
  CHECK(null.code == 0);
  CHECK(std::filesystem::is_character_file("/dev/null"));
  for (const Words& arguments : {Words{"simplify", input.path, "-o", "/dev/full", "--grid", "40"},
                                 Words{"generate", "scan", "--faces", "100k", "-o", "/dev/full"}}) {
    const Run full = run_winnow(arguments);
    INFO(full.err);
    CHECK(full.code == 4);
    CHECK(full.err.find("'/dev/full'") != std::string::npos);
  }
  const Run redirected = input.simplify_to("-", {}, {.out = "/dev/full"});
  CHECK(redirected.code == 4);
  CHECK(redirected.err.find("standard output") != std::string::npos);
}

TEST_CASE("a named pipe stays one and gets the bytes", "[faults]") {
  const Input input;
  const std::string pipe = input.directory.file("pipe");
  REQUIRE(::mkfifo(pipe.c_str(), 0600) == 0);
  Program program(Words{"simplify", input.path, "-o", pipe} + input.options);
  const std::string copy = input.directory.file("copy.ply");
  std::thread reader([&] { write_file(copy, bytes_of_file(pipe)); });
  const Run run = program.wait();
  // Lets go of a reader that nobody came for.
  const int fd = ::open(pipe.c_str(), O_WRONLY | O_NONBLOCK | O_CLOEXEC);
  if (fd >= 0) ::close(fd);
  reader.join();
  INFO(run.err);
  CHECK(run.code == 0);
  CHECK(std::filesystem::is_fifo(pipe));
  CHECK(hash_of_file(copy) == input.hash);
}

TEST_CASE("a link to an output is followed", "[faults]") {
  const Input input;
  const std::string target = input.directory.file("target.ply");
  const std::string link = input.directory.file("link.ply");
  write_file(target, "old");
  REQUIRE(::symlink("target.ply", link.c_str()) == 0);
  CHECK(input.simplify_to(link).code == 2);
  CHECK(input.simplify_to(link, {"--force"}).code == 0);
  CHECK(std::filesystem::is_symlink(link));
  CHECK(hash_of_file(target) == input.hash);
  // One that leads nowhere is refused at once, or leads to a new file; it is not found out about
  // after the work.
  ::unlink(target.c_str());
  const Run dangling = input.simplify_to(link);
  INFO(dangling.err);
  CHECK((dangling.code == 2 || hash_of_file(link) == input.hash));
}

TEST_CASE("standard streams that are closed do not end up in the mesh", "[faults]") {
  const Input input;
  const std::string output = input.directory.file("out.ply");
  for (const std::vector<int>& closed :
       {std::vector<int>{0}, std::vector<int>{1}, std::vector<int>{2}, std::vector<int>{0, 1, 2}}) {
    const Run run = input.simplify_to(output, {"--progress", "always"}, {.closed = closed});
    INFO("closed from " << closed.front() << ", " << closed.size() << ": " << run.err);
    CHECK(run.code == 0);
    CHECK(hash_of_file(output) == input.hash);
    ::unlink(output.c_str());
  }
  CHECK(input.simplify_to("-", {}, {.closed = {1}}).code == 4);
  CHECK(run_winnow({"simplify", "-", "-o", output, "--cell", "1"}, {.closed = {0}}).code == 3);
  CHECK(input.directory.names() == Words{"scan.ply"});
}

TEST_CASE("a result is there before the program says so", "[faults]") {
  const Input input;
  const std::string output = input.directory.file("out.ply");
  // A summary that cannot be written is told, but the mesh is whole.
  const Run run = input.simplify_to(output, {}, {.out = "/dev/full"});
  CHECK(run.code == 4);
  CHECK(run.err.find("standard output") != std::string::npos);
  CHECK(hash_of_file(output) == input.hash);
  for (const Words& words : {Words{"info", input.directory.file("scan.ply"), "--json"},
                             Words{"--help"}, Words{"--version"}})
    CHECK(run_winnow(words, {.out = "/dev/full"}).code == 4);
}

}  // namespace winnow::test
