// Vertices that are called by numbers of their own, as some formats do.
#pragma once

#include "io/recent_blocks.hpp"
#include "io/spool.hpp"

#include <array>
#include <cstdint>
#include <memory>
#include <span>

namespace winnow {

// Filled once, by one thread; then asked by any number of threads. Numbers that count 1, 2, 3 ...
// take nothing; all from the first other one on take eight bytes each, in memory or scratch.
class VertexNumbers {
 public:
  VertexNumbers(Job& job, std::uint64_t memory_limit);

  void add(std::span<const std::uint32_t> numbers);  // of the next vertices
  void finish();

  [[nodiscard]] bool used() const { return count_ > 0; }

  // From numbers to the vertices that have them, from 0 in their order, the last of several;
  // UINT32_MAX where none has.
  void find(std::span<std::uint32_t> numbers) const;

 private:
  struct Named;
  [[nodiscard]] std::uint32_t place_of(std::uint32_t number, RecentBlocks& others) const;
  void sort();

  Job& job_;
  std::uint64_t memory_limit_;
  std::uint64_t plain_ = 0;  // so many first vertices are called 1, 2, 3 ...
  std::uint64_t count_ = 0;
  std::unique_ptr<Spool> others_;  // by number
  std::uint32_t last_ = 0;
  bool sorted_ = true;
};

}  // namespace winnow
