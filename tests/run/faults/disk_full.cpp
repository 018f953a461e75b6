// A full disk ends with 4, names the place, and leaves nothing under the output's name nor beside
// it.
#include "support/simplified.hpp"

#include <filesystem>
#include <iostream>

#include <sched.h>
#include <sys/mount.h>
#include <sys/stat.h>

namespace winnow::test {

namespace {

void check_refused(const Run& run, const std::string& place) {
  INFO(run.err);
  CHECK(run.signal == 0);
  CHECK(run.code == 4);
  CHECK(run.err.find(place) != std::string::npos);
  CHECK(run.err.find("free some space") != std::string::npos);
  // Nothing but the error, where a report was asked for.
  CHECK((run.out.empty() || run.json()["error"]["exit_code"] == 4));
}

// A few pages of memory as a disk. Mounted where only this process and its children see it.
class SmallDisk {
 public:
  SmallDisk(const std::string& path, const std::string& size) : path_(path) {
    if (::mkdir(path.c_str(), 0755) != 0 || ::unshare(CLONE_NEWNS) != 0) return;
    if (::mount("none", "/", nullptr, MS_REC | MS_PRIVATE, nullptr) != 0) return;
    mounted_ = ::mount("tmpfs", path.c_str(), "tmpfs", 0, ("size=" + size).c_str()) == 0;
  }
  ~SmallDisk() {
    if (mounted_) ::umount2(path_.c_str(), MNT_DETACH);
  }
  SmallDisk(const SmallDisk&) = delete;
  SmallDisk& operator=(const SmallDisk&) = delete;

  [[nodiscard]] bool mounted() const {
    if (!mounted_) std::cout << "skipped: no right to mount a small disk\n";
    return mounted_;
  }
  [[nodiscard]] bool empty() const { return std::filesystem::is_empty(path_); }
  [[nodiscard]] std::string file(const std::string& name) const { return path_ + "/" + name; }

 private:
  std::string path_;
  bool mounted_ = false;
};

constexpr std::uint64_t limit = 1 << 20;
// The whole mesh stays: 3.6 MiB of output.
const Words whole{"--cell", "0.0005", "--threads", "2"};

}  // namespace

TEST_CASE("an output that outgrows the largest file is refused", "[faults]") {
  const Directory directory;
  const std::string input = directory.file("scan.ply");
  generate("scan", 200'000, input);
  for (const char* name : {"out.ply", "out.stl"}) {
    const std::string output = directory.file(name);
    const Words arguments = Words{"simplify", input, "-o", output, "--json"} + whole;
    check_refused(run_winnow(arguments, {.largest_file = limit}), output);
    CHECK(directory.names() == Words{"scan.ply"});
    // What is to be replaced stays what it is.
    write_file(output, "precious");
    check_refused(run_winnow(arguments + Words{"--force"}, {.largest_file = limit}), output);
    CHECK(bytes_of_file(output) == "precious");
    ::unlink(output.c_str());
    CHECK(directory.names() == Words{"scan.ply"});
  }
  check_refused(run_winnow({"generate", "scan", "--faces", "200k", "-o", directory.file("new.ply")},
                           {.largest_file = limit}),
                directory.file("new.ply"));
  CHECK(directory.names() == Words{"scan.ply"});
}

TEST_CASE("scratch that outgrows the largest file is refused", "[faults]") {
  const Directory directory;
  const Directory scratch;
  const std::string input = directory.file("scan.ply");
  generate("scan", 400'000, input);
  const std::string soup = directory.file("soup.stl");
  generate("scan", 100'000, soup);
  const Words before = directory.names();
  const Words where{"-o", directory.file("out.ply"), "--scratch", scratch.path()};
  // Cells and faces that do not fit; a copy of a pipe.
  const std::string memory = smallest_memory(input, whole);
  check_refused(run_winnow(Words{"simplify", input, "--memory", memory} + where + whole,
                           {.largest_file = limit}),
                scratch.path());
  Program piped(Words{"simplify", "-", "--grid", "50"} + where, {.in = "|", .largest_file = limit});
  piped.write(bytes_of_file(soup));
  check_refused(piped.wait(), scratch.path());
  CHECK(scratch.names().empty());
  CHECK(directory.names() == before);
}

TEST_CASE("scratch for faces that jump that outgrows the largest file is refused", "[faults]") {
  const Directory directory;
  const Directory scratch;
  const std::string input = directory.file("scan.ply");
  generate("scan", 1'300'000, input, {.shuffle = true});
  const auto check = [&](const Words& options, std::uint64_t most) {
    check_refused(run_winnow(Words{"simplify", input, "-o", directory.file("out.ply"), "--scratch",
                                   scratch.path(), "--memory", smallest_memory(input, options)} +
                                 options,
                             {.largest_file = most}),
                  scratch.path());
    CHECK(scratch.names().empty());
    CHECK(directory.names() == Words{"scan.ply"});
  };
  // The faces themselves, in any order; in theirs, the numbers of their vertices, and their
  // positions.
  const Words options{"--cell", "0.05", "--threads", "2"};
  check(options, limit / 2);
  check(options + Words{"--strict"}, limit / 2);
  check(options + Words{"--strict"}, 3 * limit);
}

TEST_CASE("a full disk for the output is refused", "[faults]") {
  const Directory directory;
  const SmallDisk disk(directory.file("disk"), "1m");
  if (!disk.mounted()) return;
  const std::string input = directory.file("scan.ply");
  generate("scan", 200'000, input);
  const Words options = whole + Words{"--scratch", directory.path()};
  check_refused(run_winnow(Words{"simplify", input, "-o", disk.file("out.ply")} + options),
                disk.file("out.ply"));
  CHECK(disk.empty());
  check_refused(run_winnow({"generate", "scan", "--faces", "200k", "-o", disk.file("new.stl")}),
                disk.file("new.stl"));
  CHECK(disk.empty());
  // Redirected there, what was written stays: the shell made the file, and its name is not known.
  check_refused(
      run_winnow(Words{"simplify", input, "-o", "-"} + options, {.out = disk.file("redirected")}),
      "standard output");
}

TEST_CASE("an output on another file system than scratch and input is renamed there", "[faults]") {
  const Directory directory;
  const SmallDisk disk(directory.file("disk"), "8m");
  if (!disk.mounted()) return;
  const std::string input = directory.file("scan.ply");
  generate("scan", 20'000, input);
  const std::string output = disk.file("out.ply");
  const Words arguments{"simplify", input, "-o",        output,
                        "--faces",  "2k",  "--scratch", directory.path()};
  winnow_ok(arguments);
  const std::string bytes = bytes_of_file(output);
  CHECK(std::distance(std::filesystem::directory_iterator(disk.file("")), {}) == 1);
  CHECK(directory.names() == Words{"disk", "scan.ply"});
  // A checkpoint that has its scratch elsewhere copies it.
  ::unlink(output.c_str());
  winnow_ok(arguments + Words{"--checkpoint", disk.file("kept")});
  CHECK(bytes_of_file(output) == bytes);
}

TEST_CASE("a full disk for scratch is refused", "[faults]") {
  const Directory directory;
  const SmallDisk disk(directory.file("disk"), "2m");
  if (!disk.mounted()) return;
  const std::string input = directory.file("scan.ply");
  generate("scan", 400'000, input);
  const Words before = directory.names();
  const std::string memory = smallest_memory(input, whole);
  const std::string scratch = disk.file("");
  check_refused(run_winnow(Words{"simplify", input, "-o", directory.file("out.ply"), "--scratch",
                                 scratch, "--memory", memory} +
                           whole),
                scratch);
  CHECK(disk.empty());
  CHECK(directory.names() == before);
}

}  // namespace winnow::test
