// Edges by how many faces meet in them.
#pragma once

#include <winnow/info.hpp>

#include "base/growing_pages.hpp"
#include "io/job.hpp"

#include <array>
#include <atomic>
#include <cstdint>
#include <mutex>
#include <optional>
#include <span>

namespace winnow {

// Of edges named by numbers, once for each face, in ascending order.
InfoReport::Edges count_sorted_edges(std::span<const std::uint64_t> edges, const ProgressMeter& progress);

// Keeps a 64-bit hash of every side of every face, and sorts them at the end. Two of n different edges are
// taken for one with a chance of n^2 / 2^65: for 10^8 edges, one in 3700.
class EdgeCount {
 public:
  EdgeCount(Job& job, std::uint64_t memory);

  static std::uint64_t hash_position(const std::array<double, 3>& position);
  static std::uint64_t hash_edge(std::uint64_t one_end, std::uint64_t other_end);

  void add(std::span<const std::uint64_t> edges);  // from any thread

  // Nothing where the memory was too small.
  std::optional<InfoReport::Edges> finish();
  [[nodiscard]] std::uint64_t memory_wanted() const { return added_ * sizeof(std::uint64_t); }

 private:
  Job& job_;
  GrowingPages pages_;
  std::mutex mutex_;
  std::uint64_t kept_ = 0;
  std::uint64_t added_ = 0;
  bool too_many_ = false;
};

}  // namespace winnow
