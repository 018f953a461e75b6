// What both forms of STL have in common.
#pragma once

#include <winnow/error.hpp>

#include "base/text.hpp"
#include "read/indexed/slices.hpp"
#include "read/stl/head.hpp"

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace winnow {

// Positions are the faces' corners.
class StlReader : public MeshReader {
 public:
  StlReader(Job& job, std::unique_ptr<ByteSource> source, const ReaderMemory& memory)
      : job_(job), source_(std::move(source)), memory_(memory) {}

  void begin_positions(PassCorners corners) override {
    corners_ = corners;
    begin_faces();
  }
  bool next_positions(RawBatch& batch) override { return next_faces(batch); }
  void decode_positions(const RawBatch& batch, FaceBatch& slice,
                        const PositionSink& sink) const override {
    decode_faces(batch, slice, [&](const FaceBatch& faces) { corners_as_positions(faces, sink); });
  }

  std::optional<std::array<double, 3>> first_finite_position() override {
    std::optional<std::array<double, 3>> found;
    FaceBatch slice;
    // Not restarted where the source cannot: what was peeked at is read again by begin_faces().
    begin_faces();
    if (!source_->seekable()) return peek_first_finite();
    for (RawBatch batch; !found && next_faces(batch);) {
      decode_faces(batch, slice, [&](const FaceBatch& faces) { look_for_finite(faces, found); });
    }
    return found;
  }

  [[nodiscard]] std::uint64_t bytes() const override {
    return std::max(bytes_seen_, source_->position());
  }
  [[nodiscard]] const std::string& name() const override { return source_->name(); }
  void check_whole() const override { source_->check_whole(); }

  bool next_part() override {
    if (colors_ && !colors_noted_) job_.note("not carried: colours of faces");
    colors_noted_ = colors_noted_ || colors_;
    return false;
  }

 protected:
  // On a pipe the batches looked at are kept and given out again.
  std::optional<std::array<double, 3>> peek_first_finite() {
    std::optional<std::array<double, 3>> found;
    FaceBatch slice;
    for (RawBatch batch; !found && read_faces(batch);) {
      decode_faces(batch, slice, [&](const FaceBatch& faces) { look_for_finite(faces, found); });
      const std::uint64_t seen = batch.first + batch.count;
      looked_at_.push_back(std::move(batch));
      // A pipe of nothing but bad faces must not pile up in memory.
      if (!found && looked_at_.size() >= 64) {
        throw Error(ErrorKind::bad_input, "'" + source_->name() + "': none of the first " +
                                              grouped(seen) +
                                              " faces has a finite corner; this is no mesh");
      }
    }
    return found;
  }

  static void look_for_finite(const FaceBatch& faces, std::optional<std::array<double, 3>>& found) {
    for (std::size_t i = 0; i < faces.count && !found; ++i) {
      for (std::size_t corner = 0; corner < 3; ++corner) {
        const std::array<double, 3> xyz = faces.corner(corner, i);
        if (!found && std::isfinite(xyz[0]) && std::isfinite(xyz[1]) && std::isfinite(xyz[2]))
          found = xyz;
      }
    }
  }

  bool next_faces(RawBatch& batch) final {
    if (looked_at_.empty()) return read_faces(batch);
    batch = std::move(looked_at_.front());
    looked_at_.erase(looked_at_.begin());
    return true;
  }

  virtual bool read_faces(RawBatch& batch) = 0;

  Job& job_;
  std::unique_ptr<ByteSource> source_;
  ReaderMemory memory_;
  PassCorners corners_ = PassCorners::all;
  std::vector<RawBatch> looked_at_;
  std::uint64_t next_face_ = 0;
  std::uint64_t bytes_seen_ = 0;
  bool noted_ = false;  // the end was reached once and what is odd about it was said
  mutable std::atomic<bool> colors_ = false;  // faces have some

 private:
  bool colors_noted_ = false;
};

std::unique_ptr<MeshReader> make_binary_stl_reader(Job& job, std::unique_ptr<ByteSource> source,
                                                   const ReaderMemory& memory, const StlHead& head);
std::unique_ptr<MeshReader> make_ascii_stl_reader(Job& job, std::unique_ptr<ByteSource> source,
                                                  const ReaderMemory& memory, const StlHead& head);

}  // namespace winnow
