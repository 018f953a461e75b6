// What a stream of faces adds up to.
#pragma once

#include <winnow/info.hpp>

#include "base/box.hpp"
#include "base/exact_sum.hpp"
#include "base/per_slot.hpp"
#include "measure/edge_count.hpp"
#include "read/face_batch.hpp"

#include <cstdint>

namespace winnow {

// Fed from any thread of the job's arena; the numbers do not depend on which and when.
class FaceCensus {
 public:
  FaceCensus(Job& job, std::uint64_t edge_memory);

  void add_faces(const FaceBatch& faces);
  void add_positions(const PositionView& view);  // to the box
  void add_corners(const FaceBatch& faces);      // to the box

  // Everything that is not known from the header.
  InfoReport finish();
  [[nodiscard]] std::uint64_t edge_memory_wanted() const { return edges_.memory_wanted(); }

 private:
  struct Part {
    std::uint64_t faces = 0, zero_area = 0, sides = 0;
    BadFaces bad;
    ExactSum area, edge_lengths;
    Box box;
  };
  static void add_point(Part& part, const Point& point);

  PerSlot<Part> parts_;
  EdgeCount edges_;
};

}  // namespace winnow
