#include "io/block_sums.hpp"

#include "io/scratch.hpp"

#include <algorithm>

namespace winnow {

void BlockSums::append(std::span<const std::byte> bytes) {
  while (!bytes.empty()) {
    const std::size_t length = std::min(bytes.size(), block_bytes - open_bytes_);
    open_.add(bytes.first(length));
    open_bytes_ += length;
    bytes = bytes.subspan(length);
    if (open_bytes_ == block_bytes) end_block();
  }
}

void BlockSums::end_block() {
  last_.push_back(static_cast<Sum>(open_.value()));
  open_ = {};
  open_bytes_ = 0;
  if (last_.size() < page_sums) return;
  const auto sums = std::as_bytes(std::span(last_));
  pages_.push_back({scratch_.append_shared(sums), Checksum::of(sums)});
  last_.clear();
}

void BlockSums::check(std::uint64_t offset, std::span<const std::byte> bytes) const {
  std::array<Sum, page_sums> read{};
  std::uint64_t page_read = UINT64_MAX;
  for (std::uint64_t block = offset / block_bytes; !bytes.empty(); ++block) {
    const std::uint64_t page = block / page_sums;
    const std::size_t place = block % page_sums;
    Sum expected = 0;
    if (page < pages_.size()) {
      if (page != page_read) {
        const auto sums = std::as_writable_bytes(std::span(read));
        scratch_.read_shared(pages_[page].place, sums);
        if (Checksum::of(sums) != pages_[page].sum) scratch_.damaged();
        page_read = page;
      }
      expected = read[place];
    } else {
      expected = place < last_.size() ? last_[place] : static_cast<Sum>(open_.value());
    }
    const auto content = bytes.first(std::min(bytes.size(), block_bytes));
    if (static_cast<Sum>(Checksum::of(content)) != expected) scratch_.damaged();
    bytes = bytes.subspan(content.size());
  }
}

}  // namespace winnow
