#include "io/spool.hpp"

#include <algorithm>
#include <cstring>

namespace winnow {

Spool::Spool(Job& job, std::uint64_t memory_limit) : job_(job), pages_(job.budget, memory_limit) {}

Spool::Spool(Job& job, std::uint64_t memory_limit, std::unique_ptr<ScratchFile> file)
    : Spool(job, memory_limit) {
  size_ = file->size();
  if (pages_.grow_to(size_)) {
    file->read(0, {pages_.data(), size_});
  } else {
    file_ = std::move(file);
  }
}

void Spool::append(std::span<const std::byte> bytes) {
  if (bytes.empty()) return;
  if (file_ == nullptr) {
    if (pages_.grow_to(size_ + bytes.size())) {
      std::memcpy(pages_.data() + size_, bytes.data(), bytes.size());
      size_ += bytes.size();
      return;
    }
    move_to_scratch();
  }
  if (pending_.size() + bytes.size() > scratch_write_bytes) flush();
  if (bytes.size() >= scratch_write_bytes) {
    file_->append(bytes);
  } else {
    pending_.insert(pending_.end(), bytes.begin(), bytes.end());
  }
  size_ += bytes.size();
}

void Spool::move_to_scratch() {
  file_ = std::make_unique<ScratchFile>(job_.scratch);
  if (size_ > 0) file_->append({pages_.data(), size_});
  pages_.give_back();
  pending_.reserve(scratch_write_bytes);
}

void Spool::flush() {
  file_->append(pending_);
  pending_.clear();
}

void Spool::finish() {
  if (file_ == nullptr) return;
  flush();
  pending_.shrink_to_fit();
}

void Spool::read(std::uint64_t offset, std::span<std::byte> into) const {
  if (into.empty()) return;
  if (file_ == nullptr) {
    std::memcpy(into.data(), pages_.data() + offset, into.size());
  } else {
    file_->read(offset, into);
  }
}

void Spool::for_each_part(std::size_t unit,
                          const std::function<void(std::span<const std::byte>)>& each) const {
  const std::size_t part = std::max<std::size_t>(1, scratch_write_bytes / unit) * unit;
  std::vector<std::byte> buffer(in_memory() ? 0 : part);
  for (std::uint64_t at = 0; at < size_; at += part) {
    const std::size_t length = std::min<std::uint64_t>(part, size_ - at);
    if (in_memory()) {
      each({pages_.data() + at, length});
    } else {
      file_->read(at, std::span(buffer).first(length));
      each(std::span<const std::byte>(buffer).first(length));
    }
  }
}

}  // namespace winnow
