#include "run/plan.hpp"

#include <winnow/error.hpp>

#include "base/budget.hpp"
#include "base/text.hpp"
#include "cluster/face_list.hpp"
#include "cluster/resolution.hpp"
#include "read/for_each_batch.hpp"

#include <algorithm>
#include <bit>

namespace winnow {

namespace {

// Mapped windows or blocks of a stream: 2 MiB each, a batch can hold two.
std::uint64_t blocks_in_flight(unsigned threads, std::size_t batch_faces) {
  return batches_in_flight(threads) * (batch_faces * 72 + 64 * 1024) + 3 * 2 * mebibyte;
}

}  // namespace

namespace {

constexpr std::size_t small_batch = 2048;
constexpr std::size_t large_batch = 8192;

std::size_t table_parts(unsigned threads) {
  return std::clamp<std::size_t>(std::bit_ceil(std::size_t{4} * threads), 16, 256);
}

}  // namespace

std::uint64_t MemoryPlan::smallest_for(unsigned threads, bool quadrics) {
  const std::uint64_t table = ClusterMemory::smallest_table(table_parts(threads), quadrics);
  const std::uint64_t faces = threads * ClusterMemory::smallest_faces_per_thread;
  const std::uint64_t merge = SortedRuns<CellFace>::merge_memory();
  // The smallest share decides.
  const std::uint64_t rest = std::max({table * 8 / 3, faces * 4, merge * 8, CellCounts::memory(threads)});
  const std::uint64_t fixed =
      threads * ClusterMemory::per_thread(quadrics) + blocks_in_flight(threads, small_batch);
  return (fixed + rest + mebibyte - 1) / mebibyte * mebibyte;
}

MemoryPlan MemoryPlan::divide(std::uint64_t total, std::uint64_t taken, unsigned threads, bool quadrics) {
  MemoryPlan plan;
  plan.smallest = smallest_for(threads, quadrics);
  if (total < taken + plan.smallest) {
    throw Error(ErrorKind::resources, "a memory budget of " + human_bytes(total) + " is too small for " +
                                          std::to_string(threads) + (threads == 1 ? " thread" : " threads") +
                                          "; the smallest that works is --memory " +
                                          size_option(taken + plan.smallest));
  }
  plan.cluster.table_parts = table_parts(threads);
  // Fewer faces a batch in a small budget: it bounds what is under way when the table is full.
  const bool large = total - taken >= std::max(256 * mebibyte, 4 * plan.smallest);
  plan.reader.batch_faces = large ? large_batch : small_batch;
  plan.fixed =
      threads * ClusterMemory::per_thread(quadrics) + blocks_in_flight(threads, plan.reader.batch_faces);
  // The rest in eighths: three for cells, two for faces, two for vertices of the input, one for merging.
  const std::uint64_t rest = total - taken - plan.fixed;
  plan.cluster.table = rest * 3 / 8;
  plan.cluster.faces = rest / 4;
  plan.reader.vertices = rest / 4;
  // When the input is read, its vertices make room for those of the result, and the table, once merged,
  // for the faces.
  plan.cluster.vertices = rest / 4;
  plan.cluster.result = rest / 4;
  return plan;
}

std::vector<SimplifyPlan::Part> MemoryPlan::parts() const {
  return {{"threads and blocks in flight", fixed},
          {"vertices of the input, then of the result", reader.vertices},
          {"cells", cluster.table},
          {"faces between cells", cluster.faces}};
}

std::uint64_t worst_scratch(std::uint64_t faces, bool quadrics) {
  const std::uint64_t cell = quadrics ? sizeof(QuadricCellSum) : sizeof(CellSum);
  // Three cells a face and the face itself, both twice while runs are merged; a block that does not compress
  // grows by less than a hundredth. Then three vertices and three numbers a face.
  const std::uint64_t runs = 2 * (3 * cell + sizeof(CellFace));
  return faces * (runs + runs / 100 + 1 + 3 * sizeof(IndexedVertex) + 3 * sizeof(std::uint32_t)) + mebibyte;
}

std::uint64_t expected_scratch(std::uint64_t faces, const MemoryPlan& plan, bool quadrics) {
  const std::uint64_t cell = quadrics ? sizeof(QuadricCellSum) : sizeof(CellSum);
  const std::uint64_t cells = faces / 20;
  const std::uint64_t kept = faces / 8;
  std::uint64_t bytes = 0;
  // Packed to about seven tenths.
  if (cells * cell * 3 / 2 > plan.cluster.table) bytes += cells * cell * 7 / 10;
  if (kept * sizeof(CellFace) > plan.cluster.faces) bytes += kept * sizeof(CellFace) * 7 / 10;
  if (cells * sizeof(IndexedVertex) > plan.cluster.vertices) bytes += cells * sizeof(IndexedVertex);
  if (kept * 12 > plan.cluster.result) bytes += kept * 12;
  return bytes;
}

}  // namespace winnow
