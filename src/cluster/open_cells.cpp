#include "cluster/open_cells.hpp"

#include "base/edge_hash.hpp"
#include "base/memory_shares.hpp"
#include "cluster/batch_cells.hpp"
#include "io/spool_records.hpp"

#include <array>
#include <cstddef>
#include <vector>

namespace winnow {

namespace {

constexpr unsigned log_slots = 12;

}  // namespace

struct OpenCells::CellSides {
  CellKey cell;
  std::uint64_t sum;

  static bool before(const CellSides& a, const CellSides& b) { return a.cell < b.cell; }
  static bool combine(CellSides& into, const CellSides& from) {
    into.sum ^= from.sum;
    return true;
  }
};

// On a coherent mesh most cells have nothing left when they give way.
struct OpenCells::Worker {
  explicit Worker(SortedList<CellSides>& out) : list(out) {}

  void add(PackedCell cell, std::uint64_t side) {
    CellSides& slot = recent[quick_hash(cell) >> (64 - log_slots)];
    if (slot.cell != cell) {
      give(slot);
      slot = {cell, 0};
    }
    slot.sum ^= side;
  }
  void give(const CellSides& slot) {
    if (slot.sum != 0) list.add({morton_key(PackedCell{slot.cell}), slot.sum});
  }

  SortedList<CellSides>& list;
  BatchCells cells;
  std::vector<CellSides> recent = std::vector<CellSides>(std::size_t{1} << log_slots);
};

OpenCells::OpenCells(Job& job, const Grid& grid, bool single, std::uint64_t memory)
    : job_(job),
      grid_(grid),
      single_(single),
      memory_(memory),
      sums_(std::make_unique<ThreadedRecords<CellSides>>(job, share::cluster::open_sums(memory))),
      workers_(std::make_unique<PerSlot<Worker>>(
          job.threads, [this] { return std::make_unique<Worker>(sums_->local()); })) {}

OpenCells::~OpenCells() = default;

void OpenCells::add(const FaceBatch& faces) {
  Worker& worker = workers_->local();
  worker.cells.find(faces, grid_);
  for (std::size_t i = 0; i < faces.count; ++i) {
    if (faces.status[i] != FaceStatus::good || !worker.cells.inside(i)) continue;
    const std::array<PackedCell, 3> cell = worker.cells.of(i);
    std::array<std::uint64_t, 3> end{};
    for (std::size_t c = 0; c < 3; ++c) {
      Point at = faces.corner(c, i);
      if (single_) {
        for (double& coordinate : at) coordinate = double{static_cast<float>(coordinate)};
      }
      end[c] = position_hash(at);
    }
    for (std::size_t side = 0; side < 3; ++side) {
      const std::size_t other = (side + 1) % 3;
      if (end[side] == end[other]) continue;
      const std::uint64_t hash = edge_hash(end[side], end[other]);
      worker.add(cell[side], hash);
      if (cell[other] != cell[side]) worker.add(cell[other], hash);
    }
  }
}

std::unique_ptr<Spool> OpenCells::finish() {
  for (Worker* worker : workers_->all()) {
    for (const CellSides& slot : worker->recent) worker->give(slot);
  }
  workers_.reset();
  auto cells = std::make_unique<Spool>(job_, share::cluster::open_cells(memory_));
  {
    MergedCursor<CellSides> sums = sums_->merged();
    Appender<CellKey> append(job_, *cells);
    for (CellSides cell{}; sums.next(cell);) {
      if (cell.sum != 0) append.add(cell.cell);
    }
    append.flush();
  }
  cells->finish();
  sums_.reset();
  return cells;
}

}  // namespace winnow
