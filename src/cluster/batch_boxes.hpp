// Where the faces of an input lie, block by block in its order: so that a pass for a few places
// needs to look at a few blocks only.
#pragma once

#include "base/box.hpp"
#include "io/job.hpp"
#include "read/face_batch.hpp"
#include "read/mesh_reader.hpp"

#include <cstdint>
#include <mutex>
#include <vector>

namespace winnow {

class BatchBoxes {
 public:
  explicit BatchBoxes(Job& job) : job_(job) {}

  // In the first pass, from several threads. `box`: of the faces; empty where it is not known.
  void add(const FaceBatch& faces, const Box& box);

  // Whether faces of the batch may have a corner in one of the boxes.
  [[nodiscard]] bool may_meet(const RawBatch& batch, const std::vector<Box>& boxes) const;

 private:
  static constexpr std::uint64_t block_faces = 8192;
  struct Block {
    Box box;
    bool known = true;
  };

  Job& job_;
  std::mutex adding_;
  bool in_order_ = true;
  std::vector<Block> blocks_;
  Reservation reserved_;
};

}  // namespace winnow
