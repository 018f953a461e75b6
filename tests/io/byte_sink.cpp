// An output appears whole or not at all.
#include "io/byte_sink.hpp"

#include "io/byte_source.hpp"
#include "support/files.hpp"
#include "support/job.hpp"
#include "support/random.hpp"
#include "support/sources.hpp"

#include <atomic>
#include <filesystem>
#include <thread>

#include <catch2/catch.hpp>

namespace winnow {

namespace {

using Names = std::vector<std::string>;

}  // namespace

TEST_CASE("an output is under its name only when it is finished") {
  const test::Directory directory;
  const std::string path = directory.file("out.ply");
  test::Random random(100);
  for (const std::size_t size :
       {std::size_t{0}, std::size_t{1}, std::size_t{262'144}, std::size_t{20'000'000}}) {
    const std::string content = random.bytes(size);
    test::TestJob test;
    ByteSink sink(test.job, path, false);
    std::size_t at = 0;
    for (const std::size_t part : random.parts(size, 600'000)) {
      sink.write(test::bytes_of(content.substr(at, part)));
      at += part;
    }
    CAPTURE(size);
    CHECK(sink.written() == size);
    CHECK_FALSE(test::exists(path));
    sink.finish();
    CHECK(test::bytes_of_file(path) == content);
    CHECK(directory.names() == Names{"out.ply"});
    std::filesystem::remove(path);
  }
}

TEST_CASE("an output that is not finished leaves nothing") {
  const test::Directory directory;
  for (const bool force : {false, true}) {
    test::TestJob test;
    {
      ByteSink sink(test.job, directory.file("out.ply"), force);
      sink.write(test::bytes_of(std::string(1'000'000, 'x')));
      CHECK(directory.names().size() == 1);  // it is written in the same directory
    }
    CHECK(directory.names().empty());
  }
}

TEST_CASE("an output that is not finished leaves the old file as it was") {
  const test::Directory directory;
  const std::string path = directory.file("out.ply");
  test::write_file(path, "old");
  {
    test::TestJob test;
    ByteSink sink(test.job, path, true);
    sink.write(test::bytes_of(std::string(1'000'000, 'x')));
    CHECK(test::bytes_of_file(path) == "old");
  }
  CHECK(test::bytes_of_file(path) == "old");
  CHECK(directory.names() == Names{"out.ply"});
}

TEST_CASE("an existing file is refused at once") {
  const test::Directory directory;
  const std::string path = directory.file("out.ply");
  test::write_file(path, "old");
  test::TestJob test;
  const Error error = test::error_of([&] { ByteSink(test.job, path, false); });
  CHECK(error.kind() == ErrorKind::usage);
  CHECK(std::string(error.what()).find("`force`") != std::string::npos);
  CHECK(test::bytes_of_file(path) == "old");
  CHECK(directory.names() == Names{"out.ply"});
}

TEST_CASE("a file that appears meanwhile is not replaced") {
  const test::Directory directory;
  const std::string path = directory.file("out.ply");
  {
    test::TestJob test;
    ByteSink sink(test.job, path, false);
    sink.write(test::bytes_of("mine"));
    test::write_file(path, "theirs");
    CHECK(test::error_of([&] { sink.finish(); }).kind() == ErrorKind::usage);
  }
  CHECK(test::bytes_of_file(path) == "theirs");
  CHECK(directory.names() == Names{"out.ply"});
}

TEST_CASE("what a link points to is written, the link stays") {
  const test::Directory directory;
  const test::Directory elsewhere;
  const std::string link = directory.file("link.ply");
  const std::string target = elsewhere.file("target.ply");
  std::filesystem::create_symlink(target, link);
  {
    test::TestJob test;
    ByteSink sink(test.job, link, false);  // nothing is there yet
    sink.write(test::bytes_of("first"));
    sink.finish();
  }
  CHECK(std::filesystem::is_symlink(link));
  CHECK(test::bytes_of_file(target) == "first");
  test::TestJob test;
  CHECK(test::error_of([&] { ByteSink(test.job, link, false); }).kind() == ErrorKind::usage);
  ByteSink sink(test.job, link, true);
  sink.write(test::bytes_of("second"));
  sink.finish();
  CHECK(std::filesystem::is_symlink(link));
  CHECK(test::bytes_of_file(target) == "second");
  CHECK(directory.names() == Names{"link.ply"});
  CHECK(elsewhere.names() == Names{"target.ply"});
}

TEST_CASE("an output that is taken back leaves what was there before") {
  const test::Directory directory;
  const std::string path = directory.file("out.bin");
  test::TestJob test;
  for (const bool there : {false, true}) {
    if (there) test::write_file(path, "old");
    {
      ByteSink sink(test.job, path, there);
      sink.write(test::bytes_of("new"));
      sink.finish_for_now();
      CHECK(test::bytes_of_file(path) == "new");
      sink.take_back();
    }
    CHECK(test::exists(path) == there);
    if (there) CHECK(test::bytes_of_file(path) == "old");
    CHECK(directory.names().size() == (there ? 1 : 0));
  }
}

TEST_CASE("a cancelled run does not finish its output") {
  const test::Directory directory;
  {
    test::TestJob test;
    ByteSink sink(test.job, directory.file("out.ply"), false);
    sink.write(test::bytes_of("nearly"));
    test.context.cancel();
    CHECK(test::error_of([&] { sink.finish(); }).kind() == ErrorKind::cancelled);
  }
  CHECK(directory.names().empty());
}

TEST_CASE("what a killed run had written is removed, what another run still writes is not") {
  const test::Directory directory;
  const std::string path = directory.file("out.ply");
  test::TestJob first;
  ByteSink running(first.job, path, false);
  running.write(test::bytes_of("by the one"));
  REQUIRE(directory.names().size() == 1);
  // As a killed run leaves it: the name, and no lock.
  test::write_file(
      directory.file(directory.names()[0].substr(0, directory.names()[0].size() - 6) + "killed"),
      "half");
  test::write_file(directory.file(".other.ply.winnow-killed"), "of another output");
  REQUIRE(directory.names().size() == 3);
  {
    test::TestJob second;
    ByteSink next(second.job, path, false);
    CHECK(second.job.notes.size() == 1);
    CHECK(directory.names().size() == 3);  // theirs, mine, and that of another output
  }
  CHECK(directory.names().size() == 2);
  running.finish();
  CHECK(test::bytes_of_file(path) == "by the one");
  CHECK(directory.names() == Names{".other.ply.winnow-killed", "out.ply"});
}

TEST_CASE("an output beside which many runs begin at once is not taken from any") {
  const test::Directory directory;
  const std::string path = directory.file("out.ply");
  std::vector<std::jthread> runs;
  std::atomic<int> finished{0};
  for (int i = 0; i < 12; ++i) {
    runs.emplace_back([&] {
      for (int round = 0; round < 20; ++round) {
        test::TestJob test;
        ByteSink sink(test.job, path, true);
        sink.write(test::bytes_of("whole"));
        sink.finish();
        if (test.job.notes.empty()) ++finished;  // none was taken for one that was killed
      }
    });
  }
  runs.clear();
  CHECK(finished == 240);
  CHECK(test::bytes_of_file(path) == "whole");
  CHECK(directory.names() == Names{"out.ply"});
}

TEST_CASE("an output may have the longest name that the file system allows") {
  const test::Directory directory;
  for (const std::string& letter : {std::string("n"), std::string("\xC3\xA4")}) {
    std::string name;
    while (name.size() + letter.size() + 4 <= 255) name += letter;
    const std::string path = directory.file(name + ".ply");
    test::TestJob test;
    ByteSink sink(test.job, path, false);
    sink.write(test::bytes_of("long"));
    for (const std::string& beside : directory.names()) CHECK(beside.size() <= 255);
    sink.finish();
    CHECK(test::bytes_of_file(path) == "long");
    std::filesystem::remove(path);
  }
  // Beyond is found out at once, not when all is done.
  test::TestJob test;
  const std::string longer = directory.file(std::string(256, 'n'));
  CHECK(test::error_of([&] { ByteSink(test.job, longer, false); }).kind() == ErrorKind::resources);
  CHECK(directory.names().empty());
}

TEST_CASE("a file that is written over is not read") {
  const test::Directory directory;
  const std::string path = directory.file("scan.ply");
  test::write_file(path, "ply");
  std::filesystem::create_hard_link(path, directory.file("hard.ply"));
  std::filesystem::create_symlink("scan.ply", directory.file("link.ply"));
  for (const char* output : {"scan.ply", "hard.ply", "link.ply"}) {
    for (const char* input : {"scan.ply", "hard.ply", "link.ply"}) {
      test::TestJob test;
      ByteSink sink(test.job, directory.file(output), true);
      const Error error = test::error_of([&] { open_source(test.job, directory.file(input)); });
      CHECK(error.kind() == ErrorKind::usage);
      CHECK(std::string(error.what()).find("name another output") != std::string::npos);
    }
  }
  CHECK(test::bytes_of_file(path) == "ply");
}

TEST_CASE("a place where nothing can be written is an error at once") {
  const test::Directory directory;
  test::TestJob test;
  CHECK(test::error_of([&] { ByteSink(test.job, directory.path(), false); }).kind() ==
        ErrorKind::usage);
  CHECK(test::error_of([&] {
          ByteSink(test.job, directory.file("no/such/place.ply"), true);
        }).kind() == ErrorKind::resources);
}

}  // namespace winnow
