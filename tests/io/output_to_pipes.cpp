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

namespace {

// A named pipe that is open for reading.
class Fifo {
 public:
  Fifo() {
    REQUIRE(::mkfifo(path.c_str(), 0600) == 0);
    reader = ::open(path.c_str(), O_RDONLY | O_NONBLOCK | O_CLOEXEC);
    REQUIRE(reader >= 0);
  }
  ~Fifo() { close(); }
  Fifo(const Fifo&) = delete;
  Fifo& operator=(const Fifo&) = delete;

  void close() {
    if (reader >= 0) ::close(reader);
    reader = -1;
  }

  const test::Directory directory;
  const std::string path = directory.file("pipe");
  int reader = -1;
};

}  // namespace

TEST_CASE("what is no regular file is written straight and not replaced") {
  Fifo fifo;
  test::TestJob test;
  ByteSink sink(test.job, fifo.path, false);  // needs no force
  sink.write(test::bytes_of("through"));
  sink.finish();
  std::string got(100, '\0');
  got.resize(static_cast<std::size_t>(::read(fifo.reader, got.data(), got.size())));
  fifo.close();
  CHECK(got == "through");
  CHECK(std::filesystem::is_fifo(fifo.path));
  CHECK(fifo.directory.names() == std::vector<std::string>{"pipe"});

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
  Fifo fifo;
  test::TestJob test;
  ByteSink sink(test.job, fifo.path, false);
  fifo.close();
  const Error error = test::error_of([&] {
    sink.write(test::bytes_of(std::string(1'000'000, 'x')));
    sink.finish();
  });
  CHECK(error.kind() == ErrorKind::resources);
  ::signal(SIGPIPE, before);
}

TEST_CASE("a reader that does not read does not keep a cancelled run") {
  Fifo fifo;
  test::TestJob test;
  ByteSink sink(test.job, fifo.path, false);
  const std::jthread later = test::cancel_later(test.context);
  const Stopwatch watch;
  CHECK(test::error_of([&] { sink.write(test::bytes_of(std::string(5'000'000, 'x'))); }).kind() ==
        ErrorKind::cancelled);
  CHECK(watch.seconds() < 5);
  fifo.close();
}

}  // namespace winnow
