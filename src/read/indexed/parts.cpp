#include "read/indexed/parts.hpp"

#include <algorithm>
#include <bit>
#include <cstring>

namespace winnow {

PartFiles part_files(Job& job, std::size_t parts) {
  PartFiles files;
  for (std::size_t part = 0; part < parts; ++part)
    files.push_back(std::make_unique<ScratchFile>(job.scratch));
  return files;
}

unsigned part_bits_for(std::uint64_t bytes, std::size_t record_bytes) {
  const std::uint64_t records = std::min<std::uint64_t>(bytes / record_bytes, UINT32_MAX);
  return static_cast<unsigned>(std::bit_width(std::max<std::uint64_t>(records, 1)) - 1);
}

std::uint64_t parts_of(std::uint64_t vertices, unsigned part_bits) {
  return (vertices + (std::uint64_t{1} << part_bits) - 1) >> part_bits;
}

std::size_t part_buffer_bytes(std::uint64_t memory, std::uint64_t parts) {
  constexpr std::uint64_t usual = std::uint64_t{1} << 16;
  return std::min(usual, memory / parts);
}

PartBuffers::PartBuffers(Job& job, std::size_t bytes_a_part, PartFiles& files)
    : bytes_(bytes_a_part),
      files_(files),
      memory_(Pages::allocate(job.budget, files.size() * bytes_, "sorting corners")),
      used_(files.size()) {}

void PartBuffers::append(std::size_t part, std::span<const std::byte> bytes) {
  while (!bytes.empty()) {
    const std::size_t length = std::min(bytes.size(), bytes_ - used_[part]);
    std::memcpy(memory_.data() + part * bytes_ + used_[part], bytes.data(), length);
    used_[part] += length;
    bytes = bytes.subspan(length);
    if (used_[part] == bytes_) flush(part);
  }
}

void PartBuffers::flush(std::size_t part) {
  files_[part]->append({memory_.data() + part * bytes_, used_[part]});
  used_[part] = 0;
}

void PartBuffers::finish() {
  for (std::size_t part = 0; part < files_.size(); ++part) flush(part);
}

}  // namespace winnow
