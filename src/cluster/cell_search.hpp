// The search for the cell size that gives a number of faces, by trying.
#pragma once

#include "cluster/resolution.hpp"

#include <cstdint>
#include <optional>

namespace winnow {

// Starts with what the sample expects, corrected by what came of it. Once a cell gave too many
// faces and another too few, it looks between the nearest two of them.
class CellSearch {
 public:
  CellSearch(const CellCounts& sample, double wanted_faces);

  [[nodiscard]] double next() const { return next_; }  // the cell edge to try
  void add(double cell, std::uint64_t count);          // what it gave

  // Whether no other cell is worth a try.
  [[nodiscard]] bool exhausted() const { return exhausted_; }
  [[nodiscard]] double best() const { return best_cell_; }  // of those tried
  // Whether the finest cells that there are were tried.
  [[nodiscard]] bool finest() const { return finest_; }
  [[nodiscard]] const Box& box() const { return sample_.box(); }

 private:
  struct Tried {
    double cell, faces;
  };

  [[nodiscard]] double between() const;

  const CellCounts& sample_;
  double wanted_;
  double next_;
  std::optional<Tried> too_many_, too_few_;  // the nearest on either side
  double best_cell_ = 0, best_miss_ = 0;
  // Where the whole mesh fell into one cell, nothing says how much smaller it should be.
  double smaller_by_ = 8;
  bool exhausted_ = false, finest_ = false;
};

}  // namespace winnow
