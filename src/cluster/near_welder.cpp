#include "cluster/near_welder.hpp"

#include "base/per_slot.hpp"
#include "cluster/resolution.hpp"

#include <algorithm>
#include <array>
#include <atomic>
#include <optional>
#include <utility>

namespace winnow {

namespace {

class MovingReader final : public NearWeldedReader {
 public:
  MovingReader(Job& job, std::unique_ptr<MeshReader> reader, double distance,
               const NearWeldMemory& memory)
      : reader_(std::move(reader)),
        finders_(job.threads, [this] { return std::make_unique<MovedFinder>(moved_, grid_); }) {
    const InputFacts& facts = reader_->facts();
    facts_ = facts;
    facts_.faces.reset();  // how many are left shows when they are read
    first_ = reader_->first_finite_position();
    const Box box =
        measure_box_of_most(job, *reader_, facts.vertices.value_or(facts.faces.value_or(0)));
    if (box.empty) return;
    grid_ = lattice_over(box);
    moved_ = find_moved(job, *reader_, grid_, distance, memory);
  }

  MeshReader& unwelded() override { return *reader_; }
  [[nodiscard]] std::uint64_t merged() const override { return moved_.size(); }
  [[nodiscard]] std::uint64_t collapsed() const override { return collapsed_; }

  void begin_positions(PassCorners corners) override { reader_->begin_positions(corners); }
  bool next_positions(RawBatch& batch) override { return reader_->next_positions(batch); }
  void decode_positions(const RawBatch& batch, FaceBatch& slice,
                        const PositionSink& sink) const override {
    if (moved_.size() == 0) return reader_->decode_positions(batch, slice, sink);
    std::array<std::array<double, FaceBatch::capacity>, 3> welded;
    MovedFinder& finder = finders_.local();
    reader_->decode_positions(batch, slice, [&](const PositionView& view) {
      for (std::size_t i = 0; i < view.count; ++i) {
        const Point p = finder.find({view.axis[0][i], view.axis[1][i], view.axis[2][i]});
        for (std::size_t axis = 0; axis < 3; ++axis) welded[axis][i] = p[axis];
      }
      PositionView moved = view;
      moved.axis = {welded[0].data(), welded[1].data(), welded[2].data()};
      sink(moved);
    });
  }

  void begin_faces() override {
    collapsed_ = 0;
    reader_->begin_faces();
  }
  bool next_faces(RawBatch& batch) override { return reader_->next_faces(batch); }
  void decode_faces(const RawBatch& batch, FaceBatch& slice, const FaceSink& sink) const override {
    if (moved_.size() == 0) return reader_->decode_faces(batch, slice, sink);
    MovedFinder& finder = finders_.local();
    reader_->decode_faces(batch, slice, [&](const FaceBatch& /*slice*/) {
      const auto status = slice.status;
      const bool all_good = slice.all_good;
      const bool single = slice.single;
      for (std::size_t i = 0; i < slice.count; ++i) {
        if (slice.status[i] == FaceStatus::good) move_corners(finder, slice, i);
      }
      sink(slice);
      // The reader may not set them again for every slice.
      slice.status = status;
      slice.all_good = all_good;
      slice.single = single;
    });
  }

  bool next_part() override { return reader_->next_part(); }
  std::optional<std::array<double, 3>> first_finite_position() override { return first_; }
  std::vector<AttributeRange> attribute_ranges() override { return reader_->attribute_ranges(); }
  void release_memory() override { reader_->release_memory(); }
  void check_whole() const override { reader_->check_whole(); }
  [[nodiscard]] std::uint64_t bytes() const override { return reader_->bytes(); }
  [[nodiscard]] const std::string& name() const override { return reader_->name(); }

 private:
  static void to_doubles(FaceBatch& slice) {
    for (std::size_t corner = 0; corner < 3; ++corner) {
      for (std::size_t axis = 0; axis < 3; ++axis) {
        const auto& floats = slice.single_position[corner][axis];
        std::copy_n(floats.begin(), slice.count, slice.position[corner][axis].begin());
      }
    }
    slice.single = false;
  }

  void move_corners(MovedFinder& finder, FaceBatch& slice, std::size_t face) const {
    const bool repeated = slice.repeats_a_corner(face);
    bool moved = false;
    for (std::size_t corner = 0; corner < 3; ++corner) {
      const Point stored = slice.corner(corner, face);
      const Point target = finder.find(stored);
      if (!finite(stored) || target == stored) continue;
      moved = true;
      // That of another input may be of doubles.
      if (slice.single) to_doubles(slice);
      for (std::size_t axis = 0; axis < 3; ++axis)
        slice.position[corner][axis][face] = target[axis];
    }
    if (!moved || repeated || !slice.repeats_a_corner(face)) return;
    slice.status[face] = FaceStatus::cropped;
    slice.all_good = false;
    ++collapsed_;
  }

  std::unique_ptr<MeshReader> reader_;
  std::optional<std::array<double, 3>> first_;
  Grid grid_;
  MovedPositions moved_;
  mutable PerSlot<MovedFinder> finders_;
  mutable std::atomic<std::uint64_t> collapsed_{0};
};

}  // namespace

std::unique_ptr<NearWeldedReader> weld_near(Job& job, std::unique_ptr<MeshReader> reader,
                                            double distance, const NearWeldMemory& memory) {
  return std::make_unique<MovingReader>(job, std::move(reader), distance, memory);
}

}  // namespace winnow
