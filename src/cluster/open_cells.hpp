// The cells that boundaries of the input pass through.
#pragma once

#include "base/morton.hpp"
#include "base/per_slot.hpp"
#include "cluster/grid.hpp"
#include "io/job.hpp"
#include "io/sorted_records.hpp"
#include "io/spool.hpp"
#include "read/face_batch.hpp"

#include <cstdint>
#include <memory>

namespace winnow {

// Each cell adds up the hashes of all sides of faces that have an end in it, without carrying. A
// side of two faces leaves nothing, whatever the order and the senses of the faces. So a sum that
// is not 0 tells of a side with an odd number of faces.
class OpenCells {
 public:
  // `single`: positions that are the same float are the same.
  OpenCells(Job& job, const Grid& grid, bool single, std::uint64_t memory);
  ~OpenCells();

  void add(const FaceBatch& faces);  // from any thread of the job's arena

  // Their keys, ascending, a CellKey each. The last call.
  std::unique_ptr<Spool> finish();

 private:
  struct CellSides;
  struct Worker;

  Job& job_;
  Grid grid_;
  bool single_;
  std::uint64_t memory_;
  std::unique_ptr<ThreadedRecords<CellSides>> sums_;
  std::unique_ptr<PerSlot<Worker>> workers_;
};

}  // namespace winnow
