// What goes to a name in .gz or .zst is compressed, the same bytes however it was handed over.
#include "io/byte_sink.hpp"
#include "io/byte_source.hpp"
#include "io/compressed.hpp"
#include "support/files.hpp"
#include "support/job.hpp"
#include "support/random.hpp"
#include "support/sources.hpp"

#include <filesystem>

#include <catch2/catch.hpp>

namespace winnow {

using namespace test;

namespace {

std::string plain_content(Job& job, const std::string& path) {
  const auto source = open_source(job, path);
  std::string content;
  for (Block block = source->take(100'000); !block.bytes.empty(); block = source->take(100'000))
    content += text_of({block.bytes.begin(), block.bytes.end()});
  return content;
}

void write_in_parts(const std::string& path, const std::string& content, Random& random,
                    std::size_t most) {
  TestJob test;
  ByteSink sink(test.job, path, true);
  std::size_t at = 0;
  for (const std::size_t part : random.parts(content.size(), most)) {
    sink.write(bytes_of(content.substr(at, part)));
    at += part;
  }
  CHECK_FALSE(exists(path));
  sink.finish();
  CHECK(sink.written() == content.size());
}

}  // namespace

TEST_CASE("a name in gz or zst gets what a decompressor reads back") {
  const Directory directory;
  Random random(110);
  for (const char* ending : {".gz", ".zst"}) {
    for (const std::size_t size :
         {std::size_t{0}, std::size_t{1}, std::size_t{262'144}, std::size_t{3'000'000}}) {
      CAPTURE(ending, size);
      std::string content = random.bytes(size);
      for (char& c : content) c = static_cast<char>(c & 15);  // so that there is something to gain
      const std::string path = directory.file(std::string("out.ply") + ending);
      write_in_parts(path, content, random, 300'000);
      TestJob test;
      CHECK(plain_content(test.job, path) == content);
      if (size > 1000) CHECK(size_of_file(path) < size * 3 / 4);
      const std::string head = bytes_of_file(path).substr(0, 4);
      CHECK(compression_of(bytes_of(head)) == (std::string(ending) == ".gz" ? "gzip" : "zstd"));
      const std::string first = bytes_of_file(path);
      std::filesystem::remove(path);
      write_in_parts(path, content, random, 5'000);
      CHECK(bytes_of_file(path) == first);
      std::filesystem::remove(path);
    }
  }
}

TEST_CASE("a compressed output that is not finished leaves nothing") {
  const Directory directory;
  {
    TestJob test;
    ByteSink sink(test.job, directory.file("out.zst"), false);
    sink.write(bytes_of(std::string(1'000'000, 'x')));
  }
  CHECK(directory.names().empty());
}

TEST_CASE("compressing takes its memory from the budget") {
  const Directory directory;
  for (const char* name : {"a.gz", "a.zst"}) {
    TestJob test;
    const std::uint64_t before = test.job.budget.used();
    const ByteSink sink(test.job, directory.file(name), false);
    CHECK(test.job.budget.used() > before + 100'000);
  }
}

}  // namespace winnow
