// A sequence of bytes that stays in memory while the budget allows and moves to scratch when it
// does not.
#pragma once

#include "base/growing_pages.hpp"
#include "io/job.hpp"

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <span>

namespace winnow {

// Written by appending, by one thread; then finish(); then read by any number of threads.
class Spool {
 public:
  // Uses at most `memory_limit` bytes of the budget, and none that the budget refuses.
  Spool(Job& job, std::uint64_t memory_limit);
  // Finished already: the content of `file`, in memory where it fits there.
  Spool(Job& job, std::uint64_t memory_limit, std::unique_ptr<ScratchFile> file);

  void append(std::span<const std::byte> bytes);
  void finish();

  [[nodiscard]] std::uint64_t size() const { return size_; }
  [[nodiscard]] bool in_memory() const { return file_ == nullptr; }
  [[nodiscard]] std::uint64_t memory_limit() const { return pages_.limit(); }

  // All bytes; only where in_memory().
  [[nodiscard]] const std::byte* data() const { return pages_.data(); }
  // The file; only where not in_memory().
  [[nodiscard]] const ScratchFile& file() const { return *file_; }

  void read(std::uint64_t offset, std::span<std::byte> into) const;

  // Calls `each` with the content from front to back, in parts that are multiples of `unit` bytes.
  void for_each_part(std::size_t unit,
                     const std::function<void(std::span<const std::byte>)>& each) const;

 private:
  void move_to_scratch();
  void flush();

  Job& job_;
  GrowingPages pages_;
  std::unique_ptr<ScratchFile> file_;
  std::vector<std::byte> pending_;  // bytes on their way to the file
  std::uint64_t size_ = 0;
};

}  // namespace winnow
