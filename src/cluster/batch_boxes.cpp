#include "cluster/batch_boxes.hpp"

#include <algorithm>
#include <utility>

namespace winnow {

void BatchBoxes::add(const FaceBatch& faces, const Box& box) {
  if (faces.count == 0) return;
  const std::scoped_lock lock(adding_);
  in_order_ &= faces.numbers == nullptr;
  const std::uint64_t last = (faces.first + faces.count - 1) / block_faces;
  if (last >= blocks_.size()) {
    if (last >= blocks_.capacity()) {
      const std::uint64_t capacity = std::max<std::uint64_t>(last + 1, 2 * blocks_.capacity());
      Reservation reserved = job_.budget.reserve(capacity * sizeof(Block), "where faces lie");
      blocks_.reserve(capacity);
      reserved_ = std::move(reserved);
    }
    blocks_.resize(last + 1);
  }
  for (std::uint64_t b = faces.first / block_faces; b <= last; ++b) {
    blocks_[b].known = blocks_[b].known && !box.empty;
    blocks_[b].box.add(box);
  }
}

bool BatchBoxes::may_meet(const RawBatch& batch, const std::vector<Box>& boxes) const {
  if (batch.count == 0 || !in_order_) return true;
  const std::uint64_t last = (batch.first + batch.count - 1) / block_faces;
  for (std::uint64_t b = batch.first / block_faces; b <= last; ++b) {
    if (b >= blocks_.size() || !blocks_[b].known) return true;
    const Block& block = blocks_[b];
    if (std::any_of(boxes.begin(), boxes.end(),
                    [&](const Box& box) { return boxes_meet(block.box, box); }))
      return true;
  }
  return false;
}

}  // namespace winnow
