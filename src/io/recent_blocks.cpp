#include "io/recent_blocks.hpp"

#include <algorithm>

namespace winnow {

std::span<const std::byte> RecentBlocks::block(std::uint64_t number) {
  const std::uint64_t bytes = block_records_ * record_bytes_;
  const std::uint64_t begin = number * bytes;
  const std::size_t length = std::min(bytes, spool_.size() - begin);
  if (spool_.in_memory()) return {spool_.data() + begin, length};
  Block& block = blocks_[number % most_blocks];
  if (block.number != number) {
    block.number = UINT64_MAX;  // should reading fail
    block.bytes.resize(length);
    spool_.read(begin, block.bytes);
    block.number = number;
  }
  return block.bytes;
}

}  // namespace winnow
