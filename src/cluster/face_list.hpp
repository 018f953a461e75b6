// The faces that join three cells: kept by each thread for itself, sorted, counted once.
#pragma once

#include "base/growing_pages.hpp"
#include "cluster/cell_sum.hpp"
#include "io/sorted_runs.hpp"

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

namespace winnow {

class FaceList {
 public:
  // Several lists, one a thread, share `runs`.
  FaceList(Job& job, std::uint64_t memory, SortedRuns<CellFace>& runs);

  // Three different cells, in the order of the face's corners.
  void add(CellKey a, CellKey b, CellKey c);

  // To be called before finish(), when nothing is added any more; apart, so that lists can be sorted at once.
  void sort() { sort_and_combine(); }

  // What is in memory as a cursor.
  void finish(std::vector<std::unique_ptr<RecordCursor<CellFace>>>& sources);

 private:
  [[nodiscard]] std::span<CellFace> faces() const {
    return {reinterpret_cast<CellFace*>(pages_.data()), count_};
  }
  void sort_and_combine();
  void make_room();

  Job& job_;
  Budget budget_;
  GrowingPages pages_;
  SortedRuns<CellFace>& runs_;
  std::size_t count_ = 0;
};

}  // namespace winnow
