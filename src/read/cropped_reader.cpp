#include "read/cropped_reader.hpp"

#include <limits>

namespace winnow {

namespace {

class CroppedReader final : public MeshReader {
 public:
  CroppedReader(const Box& box, std::unique_ptr<MeshReader> reader)
      : box_(box), reader_(std::move(reader)) {
    facts_ = reader_->facts();
    facts_.faces.reset();  // how many are left shows when they are read
  }

  void begin_positions(PassCorners corners) override { reader_->begin_positions(corners); }
  bool next_positions(RawBatch& batch) override { return reader_->next_positions(batch); }
  void decode_positions(const RawBatch& batch, FaceBatch& slice,
                        const PositionSink& sink) const override {
    std::array<std::array<double, FaceBatch::capacity>, 3> inside;
    reader_->decode_positions(batch, slice, [&](const PositionView& view) {
      for (std::size_t i = 0; i < view.count; ++i) {
        const Point p{view.axis[0][i], view.axis[1][i], view.axis[2][i]};
        for (std::size_t axis = 0; axis < 3; ++axis)
          inside[axis][i] = beyond(p) ? std::numeric_limits<double>::quiet_NaN() : p[axis];
      }
      PositionView moved = view;
      moved.axis = {inside[0].data(), inside[1].data(), inside[2].data()};
      sink(moved);
    });
  }

  void begin_faces() override { reader_->begin_faces(); }
  bool next_faces(RawBatch& batch) override { return reader_->next_faces(batch); }
  void decode_faces(const RawBatch& batch, FaceBatch& slice, const FaceSink& sink) const override {
    reader_->decode_faces(batch, slice, [&](const FaceBatch& /*slice*/) {
      const auto status = slice.status;
      const bool all_good = slice.all_good;
      for (std::size_t i = 0; i < slice.count; ++i) {
        if (slice.status[i] != FaceStatus::good ||
            !(beyond(slice.corner(0, i)) || beyond(slice.corner(1, i)) ||
              beyond(slice.corner(2, i)))) {
          continue;
        }
        slice.status[i] = FaceStatus::cropped;
        slice.all_good = false;
      }
      sink(slice);
      // The reader may not set them again for every slice.
      slice.status = status;
      slice.all_good = all_good;
    });
  }

  bool next_part() override { return reader_->next_part(); }

  // A corner of the box is as good to hang a lattice on, and nearer to what is kept.
  std::optional<std::array<double, 3>> first_finite_position() override {
    return reader_->first_finite_position() ? std::optional(box_.low) : std::nullopt;
  }

  std::vector<AttributeRange> attribute_ranges() override { return reader_->attribute_ranges(); }

  void release_memory() override { reader_->release_memory(); }
  void check_whole() const override { reader_->check_whole(); }
  [[nodiscard]] std::uint64_t bytes() const override { return reader_->bytes(); }
  [[nodiscard]] const std::string& name() const override { return reader_->name(); }

 private:
  // Not what is no number: that is for others to tell.
  [[nodiscard]] bool beyond(const Point& p) const {
    return p[0] < box_.low[0] || p[1] < box_.low[1] || p[2] < box_.low[2] || p[0] > box_.high[0] ||
           p[1] > box_.high[1] || p[2] > box_.high[2];
  }

  Box box_;
  std::unique_ptr<MeshReader> reader_;
};

}  // namespace

std::unique_ptr<MeshReader> crop_to(const Box& box, std::unique_ptr<MeshReader> reader) {
  return std::make_unique<CroppedReader>(box, std::move(reader));
}

}  // namespace winnow
