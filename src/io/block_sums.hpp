// Checksums of a scratch file, a block each.
#pragma once

#include "base/checksum.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace winnow {

class Scratch;

// Takes 4 bytes a block. Of a long file most are in scratch themselves: 16 bytes a MiB stay in
// memory.
class BlockSums {
 public:
  static constexpr std::size_t block_bytes = 4096;
  static constexpr std::size_t page_sums = 256;
  using Sum = std::uint32_t;

  // Bytes of scratch that so many take with the sums that go there.
  static constexpr std::uint64_t with_sums(std::uint64_t bytes) {
    return bytes + bytes / (page_sums * block_bytes) * (page_sums * sizeof(Sum));
  }

  explicit BlockSums(Scratch& scratch) : scratch_(scratch) {}

  // What the file is extended by.
  void append(std::span<const std::byte> bytes);

  // Throws Error(resources) where these are not the bytes that were appended there. Whole blocks
  // from `offset` on; the last may end with the file. By any number of threads, while none appends.
  void check(std::uint64_t offset, std::span<const std::byte> bytes) const;

 private:
  struct Page {
    std::uint64_t place;  // in what all files of the directory share
    std::uint64_t sum;    // of the sums
  };

  void end_block();

  Scratch& scratch_;
  std::vector<Page> pages_;
  std::vector<Sum> last_;  // of the blocks behind them
  Checksum open_;          // of the block that is not whole yet
  std::size_t open_bytes_ = 0;
};

}  // namespace winnow
