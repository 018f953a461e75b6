// Blocks of bytes, compressed with zstd, in a scratch file.
#pragma once

#include "io/job.hpp"

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

namespace winnow {

// Written by one thread; after finish() read by any number. Every block carries a checksum.
class PackedFile {
 public:
  explicit PackedFile(Job& job);
  ~PackedFile();
  PackedFile(const PackedFile&) = delete;
  PackedFile& operator=(const PackedFile&) = delete;

  void append(std::span<const std::byte> block);  // at most 64 KiB
  void finish();

 private:
  friend class PackedReader;
  struct Encoder;
  void flush();

  ScratchFile file_;
  std::unique_ptr<Encoder> encoder_;
  std::vector<std::byte> pending_;
};

class PackedReader {
 public:
  explicit PackedReader(const PackedFile& file);
  ~PackedReader();

  // The next block as it was appended; false at the end. Throws Error(resources) where the file is
  // damaged.
  bool next(std::vector<std::byte>& block);

 private:
  const ScratchFile& file_;
  std::uint64_t at_ = 0;
  std::vector<std::byte> packed_;
};

}  // namespace winnow
