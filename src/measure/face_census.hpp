// What a stream of faces adds up to.
#pragma once

#include <winnow/info.hpp>

#include "base/box.hpp"
#include "base/exact_sum.hpp"
#include "base/per_slot.hpp"
#include "measure/edge_count.hpp"
#include "measure/part_count.hpp"
#include "measure/surface_totals.hpp"
#include "read/face_batch.hpp"

#include <cstdint>
#include <optional>

namespace winnow {

// Fed from any thread of the job's arena; the numbers do not depend on which and when.
class FaceCensus {
 public:
  struct Memory {
    std::uint64_t edges = 0, parts = 0;
  };
  // `origin`: any point near the surface. `positions`: how many its corners are in at the most, if
  // known.
  FaceCensus(Job& job, const Memory& memory, const Point& origin,
             std::optional<std::uint64_t> positions);

  void add_faces(const FaceBatch& faces);
  void add_positions(const PositionView& view);  // to the box
  void add_corners(const FaceBatch& faces);      // to the box

  // Everything that is not known from the header.
  InfoReport finish();

 private:
  struct Part {
    explicit Part(const Point& origin) : totals(origin) {}

    std::uint64_t faces = 0, zero_area = 0, sides = 0;
    BadFaces bad;
    SurfaceTotals totals;
    ExactSum edge_lengths;
    Box box;
  };
  static void add_point(Part& part, const Point& point);

  Point origin_;
  PerSlot<Part> parts_;
  EdgeCount edges_;
  PartCount connected_;
};

}  // namespace winnow
