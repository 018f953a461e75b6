// Faces out of index lists: polygons as fans, strips as strips.
#pragma once

#include "read/mesh_reader.hpp"
#include "read/ply/header.hpp"
#include "read/ply/values.hpp"

#include <cstdint>

namespace winnow {

// Reads the records of a face (or tristrips) element one after the other, any number of triangles
// at a time: a single strip may be longer than memory.
class PlyLists {
 public:
  // `list` is the property with the indices.
  PlyLists(const PlyElement& element, const PlyProperty& list, PlyValues& values, bool strips)
      : element_(element), list_(list), values_(values), strips_(strips) {}

  // Appends up to `most` triangles to indices, status, fans and count of `batch`; fewer only at the
  // end, more where a polygon would be cut else. `most_records` limits the records that are begun.
  // `grow` is told of how many there may be, before there is memory for more than `most`, and
  // again now and then.
  void read(RawBatch& batch, std::uint64_t most, const RawBatch::Grow& grow,
            std::uint64_t most_records = UINT64_MAX);

  [[nodiscard]] bool between_records() const { return left_ == 0; }
  [[nodiscard]] std::uint64_t records() const { return records_; }  // begun so far
  void pass_over(std::uint64_t records) { records_ += records; }    // somebody else read them

 private:
  void begin_record(RawBatch& batch);
  void next_index(RawBatch& batch);
  void end_record();
  static void add(RawBatch& batch, std::uint32_t a, std::uint32_t b, std::uint32_t c,
                  FaceStatus status);

  const PlyElement& element_;
  const PlyProperty& list_;
  PlyValues& values_;
  bool strips_;
  std::uint64_t records_ = 0;
  std::uint64_t left_ = 0;  // indices of the current list still to come
  std::uint64_t seen_ = 0;  // indices of the current fan or strip
  std::uint32_t first_ = 0, before_ = 0, last_ = 0;
};

}  // namespace winnow
