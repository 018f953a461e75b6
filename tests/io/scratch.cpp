// Scratch has no name, is counted, and what others left behind is recognised.
#include "io/scratch.hpp"

#include "support/files.hpp"
#include "support/job.hpp"
#include "support/random.hpp"
#include "support/sources.hpp"

#include <filesystem>

#include <catch2/catch.hpp>
#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

namespace winnow {

TEST_CASE("scratch files have no name and hold what was appended") {
  const test::Directory directory;
  Scratch scratch(directory.path());
  test::Random random(110);
  const std::string content = random.bytes(300'000);
  ScratchFile file(scratch);
  std::size_t at = 0;
  for (const std::size_t part : random.parts(content.size(), 50'000)) {
    file.append(test::bytes_of(content).subspan(at, part));
    at += part;
  }
  CHECK(directory.names().empty());
  CHECK(file.size() == content.size());
  for (int i = 0; i < 100; ++i) {
    const std::size_t from = random.below(content.size());
    std::string part(random.below(content.size() - from), '?');
    file.read(from, std::as_writable_bytes(std::span(part)));
    REQUIRE(part == content.substr(from, part.size()));
  }
  CHECK(test::bytes_of_file(file.path()) == content);
  std::string beyond(2, '?');
  CHECK(test::error_of([&] {
          file.read(content.size() - 1, std::as_writable_bytes(std::span(beyond)));
        }).kind() == ErrorKind::resources);
}

TEST_CASE("scratch counts all that was written and the most that was in use") {
  const test::Directory directory;
  Scratch scratch(directory.path());
  const std::vector<std::byte> bytes(1000);
  {
    ScratchFile first(scratch);
    first.append(bytes);
    first.append(bytes);
    ScratchFile second(scratch);
    second.append(bytes);
  }
  ScratchFile third(scratch);
  third.append(bytes);
  CHECK(scratch.written() == 4000);
  CHECK(scratch.peak() == 3000);
}

TEST_CASE("a directory that takes no scratch is an error that says what to do") {
  const test::Directory directory;
  Scratch scratch(directory.file("missing"));
  const Error error = test::error_of([&] { ScratchFile file(scratch); });
  CHECK(error.kind() == ErrorKind::resources);
  CHECK(std::string(error.what()).find("missing") != std::string::npos);
  CHECK(std::string(error.what()).find("`scratch`") != std::string::npos);
}

TEST_CASE("stale scratch is removed, and nothing else") {
  const test::Directory directory;
  const std::string in_use = directory.file("winnow-scratch-inuse1");
  test::write_file(directory.file("winnow-scratch-stale1"), "left");
  test::write_file(directory.file("winnow-scratch-stale2"), "");
  test::write_file(in_use, "still written by another process");
  test::write_file(directory.file("my-winnow-scratch-notes"), "mine");
  test::write_file(directory.file("scan.ply"), "ply");
  std::filesystem::create_directory(directory.file("winnow-scratch-directory"));
  std::filesystem::create_symlink(directory.file("scan.ply"),
                                  directory.file("winnow-scratch-link"));
  const int fd = ::open(in_use.c_str(), O_RDWR | O_CLOEXEC);
  REQUIRE(::flock(fd, LOCK_EX | LOCK_NB) == 0);

  CHECK(remove_stale_files(directory.path(), scratch_prefix) ==
        1);  // with the one that is not empty
  CHECK_FALSE(test::exists(directory.file("winnow-scratch-stale1")));
  CHECK_FALSE(test::exists(directory.file("winnow-scratch-stale2")));
  CHECK(test::exists(in_use));
  CHECK(directory.names().size() == 5);
  CHECK(test::bytes_of_file(directory.file("scan.ply")) == "ply");

  ::close(fd);
  CHECK(remove_stale_files(directory.path(), scratch_prefix) == 1);
  CHECK(remove_stale_files(directory.path(), scratch_prefix) == 0);
  CHECK(remove_stale_files(directory.file("missing"), scratch_prefix) == 0);
}

}  // namespace winnow
