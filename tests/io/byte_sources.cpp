// Taking, giving back and peeking mean the same on every kind of source.
#include "io/byte_source.hpp"
#include "support/files.hpp"
#include "support/job.hpp"
#include "support/random.hpp"
#include "support/sources.hpp"

#include <chrono>
#include <deque>
#include <filesystem>

#include <catch2/catch.hpp>
#include <sys/stat.h>

namespace winnow {

namespace {

using test::text_of;

// A walk through `content` by takes of any size, giving back parts of what was taken. Old blocks
// are looked at again later: they stay what they were.
void walk(ByteSource& source, const std::string& content, test::Random& random, std::size_t most) {
  std::size_t at = 0;
  std::deque<Block> kept;
  while (true) {
    REQUIRE(source.position() == at);
    const std::size_t wanted =
        random.chance(0.1) ? 0 : random.between(1, random.chance(0.05) ? most : most / 20 + 1);
    const std::size_t expected = std::min(wanted, content.size() - at);
    if (random.chance(0.3)) {
      const Block ahead = source.peek(wanted);
      REQUIRE(ahead.bytes.size() == expected);
      REQUIRE(text_of(ahead.bytes) == content.substr(at, expected));
      REQUIRE(source.position() == at);
    }
    const Block block = source.take(wanted);
    REQUIRE(block.bytes.size() == expected);
    REQUIRE(text_of(block.bytes) == content.substr(at, expected));
    if (expected > 0) REQUIRE(block.offset == at);
    at += expected;
    kept.push_back(block);
    if (random.chance(0.4)) {
      const std::size_t back = random.chance(0.2) ? expected : random.below(expected + 1);
      source.give_back(back);
      at -= back;
    }
    if (kept.size() > 5) {
      const Block& old = kept.front();
      REQUIRE(text_of(old.bytes) ==
              content.substr(old.bytes.empty() ? 0 : old.offset, old.bytes.size()));
      kept.pop_front();
    }
    if (at == content.size() && random.chance(0.3)) break;
  }
  REQUIRE(source.take(100).bytes.empty());
  REQUIRE(source.take(100).bytes.empty());
  REQUIRE(source.position() == content.size());
}

}  // namespace

TEST_CASE("every source gives the plain bytes, whatever is taken and given back") {
  const test::Directory directory;
  test::Random random(80);
  // Windows are 2 MiB, blocks 1 MiB: some contents are smaller, some larger.
  for (const std::size_t size : {std::size_t{1}, std::size_t{3}, std::size_t{5000},
                                 std::size_t{1} << 20, (std::size_t{5} << 20) + 123}) {
    const std::string content = random.bytes(size);
    const std::string path = directory.file("content");
    test::write_file(path, content);
    const std::string gzipped = test::gzip_file(path);
    const std::string zstandard = test::zstd_file(path);

    const auto try_source = [&](const char* kind, const std::string& name, bool map) {
      for (const std::size_t most : {std::size_t{100'000}, std::size_t{3} << 20}) {
        test::TestJob test({.map_input = map});
        const auto source = open_source(test.job, name);
        CAPTURE(kind, size, most);
        CHECK(source->name() == name);
        CHECK(source->map_name().empty() != (std::string(kind) == "mapped"));
        walk(*source, content, random, most);
        if (!source->seekable()) continue;
        REQUIRE(source->size() == size);
        for (int i = 0; i < 10; ++i) {
          const std::size_t at = random.below(size + 1);
          source->seek(at);
          REQUIRE(source->position() == at);
          REQUIRE(text_of(source->take(777).bytes) == content.substr(at, 777));
        }
        source->seek(0);
        walk(*source, content, random, most);
      }
    };
    try_source("mapped", path, true);
    try_source("file", path, false);
    try_source("gzip", gzipped, true);
    try_source("zstd", zstandard, false);

    for (const std::string* packed : {&path, &gzipped, &zstandard}) {
      const std::string piped = test::bytes_of_file(*packed);
      const test::FedPipe pipe(piped, random.parts(piped.size(), 100'000));
      test::TestJob test({.map_input = true});
      const auto source = open_source(test.job, pipe.path());
      CAPTURE(size, *packed);
      CHECK_FALSE(source->seekable());
      CHECK_FALSE(source->size());
      CHECK(source->compression() == (packed == &path ? "" : packed == &gzipped ? "gzip" : "zstd"));
      walk(*source, content, random, 100'000);
    }
  }
}

TEST_CASE("a copy in scratch is the content of a pipe, and can be read again") {
  test::Random random(81);
  const std::string content = random.bytes((std::size_t{3} << 20) + 5);
  const test::FedPipe pipe(content);
  test::TestJob test;
  const auto copy = copy_to_scratch(test.job, open_source(test.job, pipe.path()));
  CHECK(copy->seekable());
  CHECK(copy->size() == content.size());
  CHECK_FALSE(copy->map_name().empty());
  CHECK(test.job.scratch.written() == BlockSums::with_sums(content.size()));
  walk(*copy, content, random, 500'000);
  copy->seek(0);
  walk(*copy, content, random, 500'000);
}

TEST_CASE("what cannot be read is an error that names it") {
  const test::Directory directory;
  test::TestJob test;
  const Error missing =
      test::error_of([&] { open_source(test.job, directory.file("missing.ply")); });
  CHECK(missing.kind() == ErrorKind::bad_input);
  CHECK(std::string(missing.what()).find("missing.ply") != std::string::npos);
  CHECK(test::error_of([&] { open_source(test.job, directory.path()); }).kind() ==
        ErrorKind::bad_input);

  test::write_file(directory.file("empty"), "");
  const auto empty = open_source(test.job, directory.file("empty"));
  CHECK(empty->take(10).bytes.empty());
  const test::FedPipe nothing("");
  CHECK(test::error_of([&] {
          copy_to_scratch(test.job, open_source(test.job, nothing.path()));
        }).kind() == ErrorKind::bad_input);
}

TEST_CASE("a file that became shorter is noticed when it is asked about") {
  const test::Directory directory;
  const std::string path = directory.file("content");
  for (const bool map : {false, true}) {
    test::write_file(path, std::string(100'000, 'x'));
    test::TestJob test({.map_input = map});
    const auto source = open_source(test.job, path);
    source->take(10);
    CHECK_NOTHROW(source->check_whole());
    std::filesystem::resize_file(path, 99'999);
    CAPTURE(map);
    CHECK(test::error_of([&] { source->check_whole(); }).kind() == ErrorKind::bad_input);
    std::filesystem::resize_file(path,
                                 200'000);  // longer is not wrong: it is read to where it ended
    CHECK_NOTHROW(source->check_whole());
  }
  const test::FedPipe pipe("some bytes");
  test::TestJob test;
  CHECK_NOTHROW(open_source(test.job, pipe.path())->check_whole());
}

TEST_CASE("a file that was changed and is as long as before is noticed when it is asked about") {
  const test::Directory directory;
  const std::string plain = directory.file("content");
  test::write_file(plain, std::string(100'000, 'x'));
  for (const std::string& path : {plain, test::gzip_file(plain), test::zstd_file(plain)}) {
    for (const bool map : {false, true}) {
      CAPTURE(path, map);
      test::TestJob test({.map_input = map});
      const auto source = open_source(test.job, path);
      source->take(10);
      CHECK_NOTHROW(source->check_whole());
      const auto before = std::filesystem::last_write_time(path);
      std::filesystem::last_write_time(path, before + std::chrono::nanoseconds(1));
      const Error error = test::error_of([&] { source->check_whole(); });
      CHECK(error.kind() == ErrorKind::bad_input);
      CHECK(std::string(error.what()).find("'" + path + "' was changed") != std::string::npos);
      std::filesystem::last_write_time(path, before);
      CHECK_NOTHROW(source->check_whole());
    }
  }
}

TEST_CASE("waiting for a writer of a named pipe ends when the run is cancelled") {
  const test::Directory directory;
  const std::string path = directory.file("pipe");
  REQUIRE(::mkfifo(path.c_str(), 0600) == 0);
  test::TestJob test;
  const std::jthread later = test::cancel_later(test.context);
  const Stopwatch watch;
  // Nobody writes yet: that is no end.
  CHECK(test::error_of([&] { open_source(test.job, path)->take(1); }).kind() ==
        ErrorKind::cancelled);
  CHECK(watch.seconds() < 5);
}

TEST_CASE("waiting for a pipe ends when the run is cancelled") {
  std::array<int, 2> ends{};
  REQUIRE(::pipe(ends.data()) == 0);
  REQUIRE(::write(ends[1], "plyplyply", 9) == 9);  // and then nothing, but the pipe stays open
  test::TestJob test;
  const auto source = open_source(test.job, "/proc/self/fd/" + std::to_string(ends[0]));
  const std::jthread later = test::cancel_later(test.context);
  const Stopwatch watch;
  CHECK(test::error_of([&] { source->take(100); }).kind() == ErrorKind::cancelled);
  CHECK(watch.seconds() < 5);
  ::close(ends[0]);
  ::close(ends[1]);
}

}  // namespace winnow
