// Making gzip and zstd.
#pragma once

#include "io/job.hpp"

#include <cstddef>
#include <memory>
#include <span>
#include <string>
#include <vector>

namespace winnow {

// The same calls give the same bytes.
class Compressor {
 public:
  virtual ~Compressor() = default;

  // Both append to `packed` what is ready; finish() all the rest.
  virtual void add(std::span<const std::byte> plain, std::vector<std::byte>& packed) = 0;
  virtual void finish(std::vector<std::byte>& packed) = 0;
};

// For a name that ends in .gz or .zst; nothing for others. Reserves what it needs of the budget.
std::unique_ptr<Compressor> make_compressor(Job& job, const std::string& path);

// The name without that ending.
std::string without_compression(const std::string& path);

}  // namespace winnow
