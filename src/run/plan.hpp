// How a run divides its budget, and what it will need.
#pragma once

#include <winnow/simplify.hpp>

#include "cluster/clusterer.hpp"
#include "io/job.hpp"
#include "read/mesh_reader.hpp"

#include <cstdint>

namespace winnow {

// Depends on the budget and the threads alone, so that it can be made before anything is read. Nothing in it
// changes a result.
struct MemoryPlan {
  ReaderMemory reader;
  ClusterMemory cluster;
  std::uint64_t fixed = 0;     // per-thread tables and blocks in flight
  std::uint64_t smallest = 0;  // the least total that works

  // Divides what of `total` is not `taken` already. Throws Error(resources) naming the smallest budget that
  // works.
  static MemoryPlan divide(std::uint64_t total, std::uint64_t taken, unsigned threads, bool quadrics);
  static std::uint64_t smallest_for(unsigned threads, bool quadrics);

  [[nodiscard]] std::vector<SimplifyPlan::Part> parts() const;
};

// The most scratch that any input of so many faces can need, in bytes, besides a copy of the input: every
// face in cells of its own, nothing compressed.
std::uint64_t worst_scratch(std::uint64_t faces, bool quadrics);

// What a coherent scan at a tenth of its faces needs.
std::uint64_t expected_scratch(std::uint64_t faces, const MemoryPlan& plan, bool quadrics);

}  // namespace winnow
