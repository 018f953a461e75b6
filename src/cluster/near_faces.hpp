// The faces near cells that are split, kept by their positions: they are clustered again and again.
#pragma once

#include "cluster/batch_boxes.hpp"
#include "cluster/cell_set.hpp"
#include "cluster/grid.hpp"
#include "io/job.hpp"
#include "io/spool.hpp"
#include "read/mesh_reader.hpp"

#include <cstddef>
#include <cstdint>
#include <functional>
#include <mutex>
#include <vector>

namespace winnow {

class NearFaces {
 public:
  // `attributes`: that vertices carry, as below.
  static constexpr std::uint64_t bytes_a_face(std::size_t attributes) {
    return (9 + 3 * attributes) * sizeof(double);
  }

  // `attributes`: that vertices carry. Uses at most `memory` bytes of the budget, and scratch.
  NearFaces(Job& job, std::size_t attributes, std::uint64_t memory);

  // Keeps those of all faces that have a corner in a cell of `split`. The other cells of their
  // corners are added to `beside`. The first pass over `reader` finds `boxes`; later ones, for few
  // cells, look at the blocks near `places`, the boxes of these cells.
  void read(MeshReader& reader, const Grid& grid, const CellSet& split, CellSet& beside,
            BatchBoxes& boxes);
  void read_near(MeshReader& reader, const Grid& grid, const CellSet& split, CellSet& beside,
                 const BatchBoxes& boxes, const std::vector<Box>& places);
  // The same of those that another has kept.
  void take(const NearFaces& others, const Grid& grid, const CellSet& split, CellSet& beside);

  [[nodiscard]] std::uint64_t size() const { return count_; }

  // sink(batch) from several threads, until `stop` says so between batches: true then, and the next
  // call goes on. Begins anew behind the end.
  bool for_each_batch(const FaceSink& sink, const std::function<bool()>& stop = {}) const;

 private:
  struct Worker;
  [[nodiscard]] std::size_t numbers_a_face() const {
    return bytes_a_face(attributes_) / sizeof(double);
  }
  void keep(Worker& worker);
  void choose(Worker& worker, const FaceBatch& faces, const Grid& grid, const CellSet& split,
              BatchBoxes* boxes);
  template <typename EachBatch>
  void choose_all(const EachBatch& each_batch, const Grid& grid, const CellSet& split,
                  CellSet& beside, BatchBoxes* boxes = nullptr);

  Job& job_;
  std::size_t attributes_;
  Spool faces_;
  std::mutex keeping_;
  std::uint64_t count_ = 0;
  mutable std::uint64_t next_ = 0;  // of a walk that was stopped
};

}  // namespace winnow
