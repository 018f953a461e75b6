// How a run divides its budget, and what it will need.
#pragma once

#include <winnow/simplify.hpp>

#include "cluster/clusterer.hpp"
#include "cluster/near_welder.hpp"
#include "io/job.hpp"
#include "read/mesh_reader.hpp"
#include "stitch/refine_settings.hpp"

#include <cstdint>

namespace winnow {

// Depends on the budget, the threads and what cells sum up, so that it can be made when no more
// than a header is read. Nothing in it changes a result. What is summed up of a cell besides its
// mean.
struct CellNeeds {
  bool quadrics = false;
  std::size_t attributes = 0;
  bool weld = false;  // vertices near each other become one
};

struct MemoryPlan {
  ReaderMemory reader;
  ClusterMemory cluster;
  NearWeldMemory weld;
  std::uint64_t fixed = 0;     // per-thread tables and blocks in flight
  std::uint64_t smallest = 0;  // the least total that works

  // Divides what of `total` is not `taken` already. Throws Error(resources) naming the smallest
  // budget that works.
  static MemoryPlan divide(std::uint64_t total, std::uint64_t taken, unsigned threads,
                           const CellNeeds& needs);
  static std::uint64_t smallest_for(unsigned threads, const CellNeeds& needs);

  [[nodiscard]] std::vector<SimplifyPlan::Part> parts() const;
};

// The most scratch that any input of so many faces can need, in bytes, besides a copy of the input:
// every face in cells of its own, nothing compressed.
std::uint64_t worst_scratch(std::uint64_t faces, const CellNeeds& needs);

// What clustering a coherent scan to so many faces takes.
std::uint64_t expected_scratch(std::uint64_t faces, const MemoryPlan& plan, const CellNeeds& needs);

// What refining so many faces takes at its peak: the mesh, and what is collapsed of it.
std::uint64_t refining_scratch(std::uint64_t faces, const RefineMemory& memory,
                               const CellNeeds& needs);

}  // namespace winnow
