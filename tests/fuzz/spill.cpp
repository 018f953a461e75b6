// A file of packed blocks; the bytes say which of its bytes are changed: two for the place, one for
// the value.
#include "fuzz/job.hpp"
#include "fuzz/targets.hpp"
#include "io/packed_blocks.hpp"

#include <unistd.h>

namespace winnow::fuzz {

namespace {

using Blocks = std::vector<std::vector<std::byte>>;

Blocks some_blocks() {
  Blocks blocks(3);
  for (std::size_t i = 0; i < blocks.size(); ++i) {
    for (std::size_t k = 0; k < 100 + 300 * i; ++k)
      blocks[i].push_back(static_cast<std::byte>(k * k >> i));
  }
  return blocks;
}

}  // namespace

void read_spill(std::span<const std::byte> bytes) {
  FuzzJob fuzz;
  const Blocks blocks = some_blocks();
  const int next = ::dup(0);
  ::close(next);
  PackedFile file(fuzz.job);  // which gets the number that is free
  for (const auto& block : blocks) file.append(block);
  file.finish();
  const off_t size = ::lseek(next, 0, SEEK_END);
  expect(size > 0, "the file is the one that was opened last");
  for (; bytes.size() >= 3; bytes = bytes.subspan(3)) {
    const off_t place =
        (std::to_integer<int>(bytes[0]) << 8 | std::to_integer<int>(bytes[1])) % size;
    expect(::pwrite(next, &bytes[2], 1, place) == 1, "a byte can be changed");
  }
  survives([&] {
    PackedReader reader(file);
    Blocks found;
    for (std::vector<std::byte> block; reader.next(block);) found.push_back(block);
    expect(found == blocks, "blocks are what they were, or refused");
  });
}

}  // namespace winnow::fuzz
