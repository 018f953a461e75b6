// An output that is a pipe or a device is written straight.
#include "io/byte_sink.hpp"
#include "support/files.hpp"
#include "support/job.hpp"
#include "support/sources.hpp"

#include <csignal>
#include <filesystem>
#include <string>
#include <thread>
#include <vector>

#include <catch2/catch.hpp>
#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

namespace winnow {

TEST_CASE("what is no regular file is written straight and not replaced") {
  const test::Directory directory;
  const std::string path = directory.file("pipe");
  REQUIRE(::mkfifo(path.c_str(), 0600) == 0);
  const int reader = ::open(path.c_str(), O_RDONLY | O_NONBLOCK | O_CLOEXEC);
  REQUIRE(reader >= 0);
  test::TestJob test;
  ByteSink sink(test.job, path, false);  // needs no force
  sink.write(test::bytes_of("through"));
  sink.finish();
  std::string got(100, '\0');
  got.resize(static_cast<std::size_t>(::read(reader, got.data(), got.size())));
  ::close(reader);
  CHECK(got == "through");
  CHECK(std::filesystem::is_fifo(path));
  CHECK(directory.names() == std::vector<std::string>{"pipe"});

  ByteSink nothing(test.job, "/dev/null", false);
  nothing.write(test::bytes_of("gone"));
  CHECK_NOTHROW(nothing.finish());
}

TEST_CASE("waiting for a reader of a named pipe ends when the run is cancelled") {
  const test::Directory directory;
  const std::string path = directory.file("pipe");
  REQUIRE(::mkfifo(path.c_str(), 0600) == 0);
  test::TestJob test;
  const std::jthread later = test::cancel_later(test.context);
  const Stopwatch watch;
  CHECK(test::error_of([&] { ByteSink(test.job, path, false); }).kind() == ErrorKind::cancelled);
  CHECK(watch.seconds() < 5);
}

TEST_CASE("a full disk is an error") {
  test::TestJob test;
  const Error error = test::error_of([&] {
    ByteSink sink(test.job, "/dev/full", false);
    for (int i = 0; i < 10; ++i) sink.write(test::bytes_of(std::string(100'000, 'x')));
    sink.finish();
  });
  CHECK(error.kind() == ErrorKind::resources);
  CHECK(std::string(error.what()).find("/dev/full") != std::string::npos);
}

TEST_CASE("a reader that went away is an error") {
  const auto before = ::signal(SIGPIPE, SIG_IGN);
  const test::Directory directory;
  const std::string path = directory.file("pipe");
  REQUIRE(::mkfifo(path.c_str(), 0600) == 0);
  const int reader = ::open(path.c_str(), O_RDONLY | O_NONBLOCK | O_CLOEXEC);
  test::TestJob test;
  ByteSink sink(test.job, path, false);
  ::close(reader);
  const Error error = test::error_of([&] {
    sink.write(test::bytes_of(std::string(1'000'000, 'x')));
    sink.finish();
  });
  CHECK(error.kind() == ErrorKind::resources);
  ::signal(SIGPIPE, before);
}

TEST_CASE("a reader that does not read does not keep a cancelled run") {
  const test::Directory directory;
  const std::string path = directory.file("pipe");
  REQUIRE(::mkfifo(path.c_str(), 0600) == 0);
  const int reader = ::open(path.c_str(), O_RDONLY | O_NONBLOCK | O_CLOEXEC);
  test::TestJob test;
  ByteSink sink(test.job, path, false);
  const std::jthread later = test::cancel_later(test.context);
  const Stopwatch watch;
  CHECK(test::error_of([&] { sink.write(test::bytes_of(std::string(5'000'000, 'x'))); }).kind() ==
        ErrorKind::cancelled);
  CHECK(watch.seconds() < 5);
  ::close(reader);
}

}  // namespace winnow
