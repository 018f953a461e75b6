#include "io/spooled_source.hpp"

#include <algorithm>
#include <cstring>
#include <numeric>
#include <utility>

namespace winnow {

namespace {

class SpooledSource final : public ByteSource {
 public:
  SpooledSource(std::string name, std::string head, std::vector<std::unique_ptr<Spool>> spools)
      : ByteSource(std::move(name), ""), head_(std::move(head)), spools_(std::move(spools)) {
    size_ = head_.size();
    for (const auto& spool : spools_) size_ += spool->size();
  }

  Block take(std::size_t bytes) override {
    const std::size_t length = std::min<std::uint64_t>(bytes, size_ - position_);
    if (length == 0) return {};
    const std::shared_ptr<std::byte[]> copy(new std::byte[length]);
    read(position_, {copy.get(), length});
    Block block{{copy.get(), length}, position_, copy, nullptr};
    position_ += length;
    return block;
  }

  void give_back(std::size_t bytes) override { position_ -= bytes; }
  [[nodiscard]] std::uint64_t position() const override { return position_; }
  [[nodiscard]] std::optional<std::uint64_t> size() const override { return size_; }
  [[nodiscard]] bool seekable() const override { return true; }
  void seek(std::uint64_t position) override { position_ = std::min(position, size_); }

 private:
  void read(std::uint64_t at, std::span<std::byte> into) const {
    if (at < head_.size()) {
      const std::size_t length = std::min<std::uint64_t>(into.size(), head_.size() - at);
      std::memcpy(into.data(), head_.data() + at, length);
      into = into.subspan(length);
      at += length;
    }
    std::uint64_t begin = head_.size();
    for (const auto& spool : spools_) {
      const std::uint64_t end = begin + spool->size();
      if (!into.empty() && at < end) {
        const std::size_t length = std::min<std::uint64_t>(into.size(), end - at);
        spool->read(at - begin, into.first(length));
        into = into.subspan(length);
        at += length;
      }
      begin = end;
    }
  }

  std::string head_;
  std::vector<std::unique_ptr<Spool>> spools_;
  std::uint64_t size_ = 0;
  std::uint64_t position_ = 0;
};

}  // namespace

std::unique_ptr<ByteSource> spooled_source(std::string name, std::string head,
                                           std::vector<std::unique_ptr<Spool>> spools) {
  return std::make_unique<SpooledSource>(std::move(name), std::move(head), std::move(spools));
}

}  // namespace winnow
