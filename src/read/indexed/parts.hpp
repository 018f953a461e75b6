// Scratch in parts, each for a range of vertex numbers: what is read in one order and needed in
// another.
#pragma once

#include "base/pages.hpp"
#include "io/job.hpp"
#include "io/scratch.hpp"
#include "read/mesh_reader.hpp"

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <vector>

namespace winnow {

// The next faces; false at the end.
using NextFaces = std::function<bool(RawBatch&)>;

using PartFiles = std::vector<std::unique_ptr<ScratchFile>>;

PartFiles part_files(Job& job, std::size_t parts);

// The bits of a part's vertex numbers, so that their records take at most `bytes`.
unsigned part_bits_for(std::uint64_t bytes, std::size_t record_bytes);

std::uint64_t parts_of(std::uint64_t vertices, unsigned part_bits);

// Of each of so many parts, while they are written.
std::size_t part_buffer_bytes(std::uint64_t memory, std::uint64_t parts);

// Bytes on their way to the files of all parts, side by side. For one thread.
class PartBuffers {
 public:
  PartBuffers(Job& job, std::size_t bytes_a_part, PartFiles& files);

  // Records of all parts one after the other, each part's up to its end.
  template <typename Record>
  void append(const std::vector<Record>& sorted, const std::vector<std::uint32_t>& ends) {
    const std::span<const Record> records(sorted);
    std::uint32_t begin = 0;
    for (std::size_t part = 0; part < files_.size(); ++part) {
      append(part, std::as_bytes(records.subspan(begin, ends[part] - begin)));
      begin = ends[part];
    }
  }
  void finish();

 private:
  void append(std::size_t part, std::span<const std::byte> bytes);
  void flush(std::size_t part);

  std::size_t bytes_;  // of each part
  PartFiles& files_;
  Pages memory_;
  std::vector<std::size_t> used_;
};

}  // namespace winnow
