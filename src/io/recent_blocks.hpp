// Records of a spool in whatever order: those near others that were asked for lately come from
// memory.
#pragma once

#include "io/spool.hpp"

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <span>
#include <vector>

namespace winnow {

// For one thread. The spool must be finished, and stay.
class RecentBlocks {
 public:
  static constexpr std::size_t block_bytes = 12288;
  static constexpr std::size_t most_blocks = 64;

  RecentBlocks(const Spool& spool, std::size_t record_bytes)
      : spool_(spool), record_bytes_(record_bytes), block_records_(records_a_block(record_bytes)) {
    if (!spool.in_memory()) blocks_.resize(most_blocks);
  }

  static constexpr std::size_t records_a_block(std::size_t record_bytes) {
    return record_bytes > block_bytes ? 1 : block_bytes / record_bytes;
  }

  // Both are valid until the next call. The last block may be shorter.
  [[nodiscard]] std::span<const std::byte> block(std::uint64_t number);
  [[nodiscard]] std::span<const std::byte> record(std::uint64_t number) {
    if (spool_.in_memory()) return {spool_.data() + number * record_bytes_, record_bytes_};
    return block(number / block_records_)
        .subspan(number % block_records_ * record_bytes_, record_bytes_);
  }

  // The same as a value; records must be of that type.
  template <typename Record>
  [[nodiscard]] Record at(std::uint64_t number) {
    Record value;
    std::memcpy(&value, record(number).data(), sizeof value);
    return value;
  }

 private:
  struct Block {
    std::uint64_t number = UINT64_MAX;
    std::vector<std::byte> bytes;
  };

  const Spool& spool_;
  std::size_t record_bytes_, block_records_;
  std::vector<Block> blocks_;  // of a spool in scratch, each where its number says
};

}  // namespace winnow
