#include "run/plan.hpp"

#include <winnow/error.hpp>

#include "base/budget.hpp"
#include "base/memory_shares.hpp"
#include "base/text.hpp"
#include "cluster/attribute_means.hpp"
#include "cluster/boundary_sum.hpp"
#include "cluster/face_list.hpp"
#include "cluster/resolution.hpp"
#include "read/for_each_batch.hpp"
#include "stitch/collapse_log.hpp"

#include <algorithm>
#include <bit>

namespace winnow {

namespace {

// Mapped windows or blocks of a stream: 2 MiB each, a batch can hold two.
std::uint64_t blocks_in_flight(unsigned threads, std::size_t faces) {
  return batches_in_flight(threads) * (faces * 72 + 64 * 1024) + 3 * 2 * mebibyte;
}

}  // namespace

namespace {

constexpr std::size_t small_batch = 2048;
constexpr std::size_t large_batch = 8192;

std::size_t table_parts(unsigned threads) {
  return std::clamp<std::size_t>(std::bit_ceil(std::size_t{4} * threads), 16, 256);
}

std::uint64_t per_thread(const CellNeeds& needs) {
  return ClusterMemory::per_thread(needs.quadrics) + AttributeMemory::per_thread(needs.attributes) +
         (needs.weld ? NearWeldMemory::per_thread() : 0);
}

std::uint64_t cell_size(const CellNeeds& needs) {
  return needs.quadrics ? sizeof(QuadricCellSum) : sizeof(CellSum);
}

std::uint64_t vertex_size(const CellNeeds& needs) {
  return sizeof(IndexedVertex) + needs.attributes * sizeof(double);
}

}  // namespace

std::uint64_t MemoryPlan::smallest_for(unsigned threads, const CellNeeds& needs) {
  const std::size_t parts = table_parts(threads);
  const std::uint64_t table = ClusterMemory::smallest_table(parts, needs.quadrics) +
                              AttributeMemory::smallest_table(parts, needs.attributes);
  const std::uint64_t faces = threads * ClusterMemory::smallest_faces_per_thread;
  // Runs of attributes are merged beside those of cells.
  const std::uint64_t merge = SortedRuns<CellFace>::merge_memory() * (needs.attributes > 0 ? 2 : 1);
  // The smallest share decides.
  const std::uint64_t rest =
      std::max({share::plan::cells.whole(table), share::plan::faces.whole(faces),
                share::plan::merging.whole(merge), CellCounts::memory(threads)}) *
      (needs.weld ? 4 : 3) / 3;
  const std::uint64_t fixed = threads * per_thread(needs) + blocks_in_flight(threads, small_batch);
  return (fixed + rest + mebibyte - 1) / mebibyte * mebibyte;
}

MemoryPlan MemoryPlan::divide(std::uint64_t total, std::uint64_t taken, unsigned threads,
                              const CellNeeds& needs) {
  MemoryPlan plan;
  plan.smallest = smallest_for(threads, needs);
  if (total < taken + plan.smallest) {
    throw Error(ErrorKind::resources,
                "a memory budget of " + human_bytes(total) + " is too small for " +
                    std::to_string(threads) + (threads == 1 ? " thread" : " threads") +
                    "; the smallest that works is `memory` " + size_option(taken + plan.smallest));
  }
  plan.cluster.table_parts = table_parts(threads);
  // Fewer faces a batch in a small budget: it bounds what is under way when the table is full.
  const bool large = total - taken >= std::max(256 * mebibyte, 4 * plan.smallest);
  plan.reader.batch_faces = large ? large_batch : small_batch;
  plan.fixed = threads * per_thread(needs) + blocks_in_flight(threads, plan.reader.batch_faces);
  std::uint64_t rest = total - taken - plan.fixed;
  if (needs.weld) {
    // What has moved is looked up for as long as faces are read. The rest of what welding takes is
    // free before they are clustered.
    plan.weld.moved = share::plan::moved(rest);
    rest -= plan.weld.moved;
    plan.weld.sorting = share::plan::weld_sorting(rest);
    plan.weld.links = share::plan::weld_links(rest);
    plan.weld.positions = share::plan::weld_positions(rest);
  }
  plan.cluster.table = share::plan::cells(rest);
  if (needs.attributes > 0) {
    // As many cells in either table.
    const std::uint64_t entry = AttributeMemory::entry_size(needs.attributes);
    const std::uint64_t cell = cell_size(needs);
    plan.cluster.attributes = plan.cluster.table / (cell + entry) * entry;
    plan.cluster.table -= plan.cluster.attributes;
  }
  plan.cluster.faces = share::plan::faces(rest);
  plan.reader.vertices = share::plan::input_vertices(rest);
  plan.cluster.vertices = share::plan::vertices(rest);
  plan.cluster.result = share::plan::result(rest);
  return plan;
}

std::vector<SimplifyPlan::Part> MemoryPlan::parts() const {
  std::vector<SimplifyPlan::Part> parts{
      {"threads and blocks in flight", fixed},
      {"vertices of the input, then of the result", reader.vertices},
      {"cells", cluster.table},
      {"faces between cells", cluster.faces}};
  if (weld.moved > 0) parts.push_back({"vertices that `weld` moved", weld.moved});
  if (cluster.attributes > 0) parts.push_back({"attributes of cells", cluster.attributes});
  return parts;
}

std::uint64_t worst_scratch(std::uint64_t faces, const CellNeeds& needs) {
  const std::uint64_t cell = cell_size(needs) + AttributeMemory::entry_size(needs.attributes);
  // Three cells a face, with what boundaries in them add up to, and the face itself, all twice
  // while runs are merged; a block that does not compress grows by less than a hundredth. Then
  // three vertices and three numbers a face.
  const std::uint64_t runs = 2 * (3 * (cell + sizeof(BoundarySum)) + sizeof(CellFace));
  const std::uint64_t vertex = vertex_size(needs);
  const std::uint64_t weld = needs.weld ? near_weld_scratch(faces) : 0;
  return weld + weld / 100 +
         faces * (runs + runs / 100 + 1 + 3 * vertex + MeshLayout::face_bytes()) + mebibyte;
}

std::uint64_t expected_scratch(std::uint64_t faces, const MemoryPlan& plan,
                               const CellNeeds& needs) {
  const std::uint64_t cell = cell_size(needs) + AttributeMemory::entry_size(needs.attributes);
  const std::uint64_t cells = faces / 2;
  const std::uint64_t kept = faces + faces / 4;
  std::uint64_t bytes = 0;
  // Packed to about seven tenths.
  if (cells * cell * 3 / 2 > plan.cluster.table + plan.cluster.attributes)
    bytes += cells * cell * 7 / 10;
  if (kept * sizeof(CellFace) > plan.cluster.faces) bytes += kept * sizeof(CellFace) * 7 / 10;
  const std::uint64_t vertex = vertex_size(needs);
  if (cells * vertex > plan.cluster.vertices) bytes += cells * vertex;
  const std::uint64_t numbered = kept * MeshLayout::face_bytes();
  if (numbered > plan.cluster.result) bytes += numbered;
  return bytes;
}

std::uint64_t refining_scratch(std::uint64_t faces, const RefineMemory& memory,
                               const CellNeeds& needs) {
  const std::uint64_t vertices = faces / 2 * vertex_size(needs);
  const std::uint64_t corners = faces * sizeof(FaceVertices);
  const std::uint64_t collapses = faces / 2 * CollapseLog::entry_size;
  std::uint64_t bytes = 0;
  for (const std::uint64_t part : {vertices, corners}) bytes += part > memory.mesh ? part : 0;
  return bytes + (collapses > memory.logs ? collapses : 0);
}

}  // namespace winnow
