// A disk that changes bytes is noticed.
#include "io/byte_source.hpp"
#include "io/packed_blocks.hpp"
#include "io/spool.hpp"
#include "support/job.hpp"
#include "support/random.hpp"
#include "support/scratch_files.hpp"
#include "support/sources.hpp"

#include <optional>

#include <catch2/catch.hpp>

namespace winnow {

namespace {

using Blocks = std::vector<std::vector<std::byte>>;

Blocks random_blocks(std::size_t count, std::size_t most) {
  test::Random random(60);
  Blocks blocks(count);
  for (auto& block : blocks) {
    const std::string text = random.bytes(random.between(1, most));
    block.assign(reinterpret_cast<const std::byte*>(text.data()),
                 reinterpret_cast<const std::byte*>(text.data()) + text.size());
  }
  return blocks;
}

// All blocks, or nothing where reading them failed as it should.
std::optional<Blocks> read(const PackedFile& file) {
  try {
    PackedReader reader(file);
    Blocks blocks;
    for (std::vector<std::byte> block; reader.next(block);) blocks.push_back(block);
    return blocks;
  } catch (const Error& error) {
    REQUIRE(error.kind() == ErrorKind::resources);
    return {};
  }
}

// Short blocks in a file that can be damaged.
struct Packed {
  explicit Packed(std::size_t count) : blocks(random_blocks(count, 300)) {
    for (const auto& block : blocks) file.append(block);
    file.finish();
  }

  Blocks blocks;
  test::TestJob test;
  std::set<int> before = test::descriptors();
  PackedFile file{test.job};
  test::OpenedFile opened{test::opened_since(before).front()};
};

}  // namespace

TEST_CASE("blocks come back as they were appended") {
  test::TestJob test;
  const Blocks blocks = random_blocks(40, 1 << 16);
  PackedFile file(test.job);
  for (const auto& block : blocks) file.append(block);
  file.finish();
  CHECK(read(file) == blocks);
  CHECK(read(file) == blocks);
}

TEST_CASE("any changed bit of a scratch file is an error, never other data") {
  const Packed packed(5);
  REQUIRE(read(packed.file) == packed.blocks);
  const std::uint64_t size = packed.opened.size();
  for (std::uint64_t byte = 0; byte < size; ++byte) {
    // Higher bits of a length are tried below.
    const unsigned bit = static_cast<unsigned>(byte % 8);
    packed.opened.flip(byte, bit);
    const std::optional<Blocks> found = read(packed.file);
    CAPTURE(byte, bit);
    // zstd does not look at every bit of its frame header; but what comes must be what went.
    REQUIRE((!found || *found == packed.blocks));
    packed.opened.flip(byte, bit);
  }
  REQUIRE(read(packed.file) == packed.blocks);
}

TEST_CASE("a changed length asks for no more memory than a block has") {
  const Packed packed(2);
  for (const std::uint64_t byte :
       {3, 7}) {  // the highest byte of the packed and of the plain length
    const std::uint64_t peak = peak_resident_bytes();
    packed.opened.flip(byte, 4);
    CHECK_FALSE(read(packed.file));
    packed.opened.flip(byte, 4);
    CAPTURE(byte);
    CHECK(peak_resident_bytes() - peak < std::uint64_t{100} << 20);
  }
}

TEST_CASE("zeros in the place of blocks are an error") {
  const Packed packed(3);
  packed.opened.clear(0, 8);
  CHECK_FALSE(read(packed.file));
  packed.opened.clear(0, static_cast<std::size_t>(packed.opened.size()));
  CHECK_FALSE(read(packed.file));
}

TEST_CASE("a scratch file that lost its end is an error") {
  const Packed packed(3);
  const std::uint64_t size = packed.opened.size();
  for (const std::uint64_t lost : {std::uint64_t{1}, std::uint64_t{9}, size}) {
    packed.opened.cut(size - lost);
    CAPTURE(lost);
    CHECK_FALSE(read(packed.file));
  }
}

namespace {

// What stands there, or nothing where reading it failed as it should.
template <typename Readable>
std::optional<std::string> read(const Readable& file, std::uint64_t from, std::size_t length) {
  std::string bytes(length, '?');
  try {
    file.read(from, std::as_writable_bytes(std::span(bytes)));
  } catch (const Error& error) {
    REQUIRE(error.kind() == ErrorKind::resources);
    REQUIRE(std::string(error.what()).find("is damaged") != std::string::npos);
    return {};
  }
  return bytes;
}

}  // namespace

TEST_CASE("whatever is read of a scratch file with a changed bit is right, or an error") {
  test::Random random(61);
  for (const std::size_t size : {std::size_t{1}, std::size_t{4095}, std::size_t{4096},
                                 std::size_t{70'001}, std::size_t{2'500'003}}) {
    const std::string content = random.bytes(size);
    test::TestJob test;
    const std::set<int> before = test::descriptors();
    ScratchFile file(test.job.scratch);
    std::size_t at = 0;
    for (const std::size_t part : random.parts(size, 30'000)) {
      file.append(test::bytes_of(content).subspan(at, part));
      at += part;
    }
    const std::vector<int> opened = test::opened_since(before);
    // Checksums of the longest are in a file, too.
    REQUIRE(opened.size() == (size > (std::size_t{1} << 20) ? 2 : 1));
    for (int round = 0; round < 60; ++round) {
      const bool of_sums = opened.size() == 2 && round % 4 == 0;
      const test::OpenedFile damaged(of_sums ? opened.back() : opened.front());
      const std::uint64_t byte = random.below(damaged.size());
      const auto bit = static_cast<unsigned>(random.below(8));
      CAPTURE(size, of_sums, byte, bit);
      REQUIRE(read(file, 0, size) == content);
      damaged.flip(byte, bit);
      CHECK_FALSE(read(file, 0, size));
      if (!of_sums) CHECK_FALSE(read(file, byte, 1));
      for (int i = 0; i < 20; ++i) {
        const std::size_t from = random.below(size + 1);
        const std::size_t length = random.below(std::min<std::size_t>(size - from, 9'000) + 1);
        const std::optional<std::string> found = read(file, from, length);
        REQUIRE((!found || *found == content.substr(from, length)));
      }
      damaged.flip(byte, bit);
    }
  }
}

TEST_CASE("a spool that moved to scratch notices a changed bit, one in memory has none") {
  test::Random random(62);
  const std::string content = random.bytes(3'000'000);
  for (const std::uint64_t limit : {std::uint64_t{0}, std::uint64_t{1} << 20}) {
    test::TestJob test;
    const std::set<int> before = test::descriptors();
    Spool spool(test.job, limit);
    spool.append(test::bytes_of(content).first(500'000));
    spool.append(test::bytes_of(content).subspan(500'000));
    spool.finish();
    const test::OpenedFile damaged(test::opened_since(before).front());
    damaged.flip(1'234'567, 3);
    CHECK_FALSE(read(spool, 1'234'567, 1));
    CHECK_FALSE(read(spool, 0, content.size()));
    CHECK(read(spool, 2'000'000, 1'000) == content.substr(2'000'000, 1'000));
    CHECK_THROWS_AS(spool.for_each_part(12, [](std::span<const std::byte>) {}), Error);
  }
}

TEST_CASE("a copy of a pipe in scratch is mapped, and a changed bit in it noticed all the same") {
  test::Random random(63);
  const std::string content = random.bytes(5'000'000);
  const test::FedPipe pipe(content);
  test::TestJob test;
  auto piped = open_source(test.job, pipe.path());
  const std::set<int> before = test::descriptors();
  const auto copy = copy_to_scratch(test.job, std::move(piped));
  const test::OpenedFile damaged(test::opened_since(before).front());
  const auto walk = [&] {
    copy->seek(0);
    std::string all;
    for (Block block; !(block = copy->take(300'000)).bytes.empty();)
      all += test::text_of(block.bytes);
    return all;
  };
  CHECK(walk() == content);
  for (const std::uint64_t byte :
       {std::uint64_t{0}, std::uint64_t{2'100'000}, content.size() - 1}) {
    damaged.flip(byte, 5);
    CAPTURE(byte);
    CHECK_THROWS_AS(walk(), Error);
    damaged.flip(byte, 5);
  }
  CHECK(walk() == content);
}

}  // namespace winnow
