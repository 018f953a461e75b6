// The faces of a batch, told apart by the cells that their corners lie in.
#pragma once

#include "cluster/kernel/corner_kernel.hpp"
#include "read/face_batch.hpp"

#include <array>
#include <cstddef>
#include <cstdint>

namespace winnow {

// Indices into a batch.
class FaceIndices {
 public:
  [[nodiscard]] const std::uint16_t* begin() const { return index_.data(); }
  [[nodiscard]] const std::uint16_t* end() const { return index_.data() + count_; }
  [[nodiscard]] std::size_t size() const { return count_; }
  std::size_t operator[](std::size_t k) const { return index_[k]; }

  void clear() { count_ = 0; }
  // Without a branch.
  void add_if(bool wanted, std::size_t i) {
    index_[count_] = static_cast<std::uint16_t>(i);
    count_ += wanted ? 1 : 0;
  }

 private:
  std::array<std::uint16_t, kernel_capacity + 1> index_;  // one more for what is not wanted
  std::size_t count_ = 0;
};

// So that each kind has a loop of its own.
class FaceKinds {
 public:
  FaceIndices inside, pairs, across, bad;  // one cell, two and three; all others

  void tell_apart(const CornerSums& corners, const FaceBatch& faces) {
    for (FaceIndices* indices : {&inside, &pairs, &across, &bad, &others_}) indices->clear();
    for (std::size_t i = 0; i < faces.count; ++i) {
      const bool one = (corners.kind[i] == one_cell) & (faces.status[i] == FaceStatus::good);
      inside.add_if(one, i);
      others_.add_if(!one, i);
    }
    for (const std::size_t i : others_) {
      const std::int64_t kind = corners.kind[i];
      const bool good = faces.status[i] == FaceStatus::good;
      pairs.add_if((kind >= alone_a) & (kind <= alone_c) & good, i);
      across.add_if((kind == three_cells) & good, i);
      bad.add_if((kind > three_cells) | !good, i);
    }
  }

 private:
  FaceIndices others_;
};

}  // namespace winnow
