// A disk that changes bytes is noticed.
#include "io/packed_blocks.hpp"
#include "support/job.hpp"
#include "support/random.hpp"

#include <optional>
#include <set>

#include <catch2/catch.hpp>
#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

namespace winnow {

namespace {

std::set<int> descriptors() {
  std::set<int> open;
  for (const auto& entry : std::filesystem::directory_iterator("/proc/self/fd")) {
    open.insert(std::stoi(entry.path().filename()));
  }
  std::erase_if(open, [](int fd) { return ::fcntl(fd, F_GETFD) == -1; });  // that of the list itself
  return open;
}

// A scratch file has no name; this finds the descriptor it is behind.
class Opened {
 public:
  explicit Opened(const std::set<int>& before) {
    for (const int fd : descriptors()) {
      if (before.count(fd) == 0) fd_ = fd;
    }
    REQUIRE(fd_ >= 0);
  }

  [[nodiscard]] std::uint64_t size() const {
    struct stat status {};
    ::fstat(fd_, &status);
    return static_cast<std::uint64_t>(status.st_size);
  }

  void flip(std::uint64_t byte, unsigned bit) const {
    unsigned char value = 0;
    REQUIRE(::pread(fd_, &value, 1, static_cast<off_t>(byte)) == 1);
    value = static_cast<unsigned char>(value ^ 1U << bit);
    REQUIRE(::pwrite(fd_, &value, 1, static_cast<off_t>(byte)) == 1);
  }

  void cut(std::uint64_t size) const { REQUIRE(::ftruncate(fd_, static_cast<off_t>(size)) == 0); }

 private:
  int fd_ = -1;
};

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
  test::TestJob test;
  const Blocks blocks = random_blocks(5, 300);
  const std::set<int> before = descriptors();
  PackedFile file(test.job);
  const Opened opened(before);
  for (const auto& block : blocks) file.append(block);
  file.finish();
  REQUIRE(read(file) == blocks);
  const std::uint64_t size = opened.size();
  for (std::uint64_t byte = 0; byte < size; ++byte) {
    // Higher bits of a length are tried below.
    const unsigned bit = static_cast<unsigned>(byte % 8);
    opened.flip(byte, bit);
    const std::optional<Blocks> found = read(file);
    CAPTURE(byte, bit);
    // zstd does not look at every bit of its frame header; but what comes must be what went.
    REQUIRE((!found || *found == blocks));
    opened.flip(byte, bit);
  }
  REQUIRE(read(file) == blocks);
}

TEST_CASE("a changed length asks for no more memory than a block has") {
  test::TestJob test;
  const Blocks blocks = random_blocks(2, 300);
  const std::set<int> before = descriptors();
  PackedFile file(test.job);
  const Opened opened(before);
  for (const auto& block : blocks) file.append(block);
  file.finish();
  for (const std::uint64_t byte : {3, 7}) {  // the highest byte of the packed and of the plain length
    const std::uint64_t peak = peak_resident_bytes();
    opened.flip(byte, 4);
    CHECK_FALSE(read(file));
    opened.flip(byte, 4);
    CAPTURE(byte);
    CHECK(peak_resident_bytes() - peak < std::uint64_t{100} << 20);
  }
}

TEST_CASE("a scratch file that lost its end is an error") {
  test::TestJob test;
  const Blocks blocks = random_blocks(3, 300);
  const std::set<int> before = descriptors();
  PackedFile file(test.job);
  const Opened opened(before);
  for (const auto& block : blocks) file.append(block);
  file.finish();
  const std::uint64_t size = opened.size();
  for (const std::uint64_t lost : {std::uint64_t{1}, std::uint64_t{9}, size}) {
    opened.cut(size - lost);
    CAPTURE(lost);
    CHECK_FALSE(read(file));
  }
}

}  // namespace winnow
