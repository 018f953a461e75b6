// What readers of formats with shared vertices have in common.
#pragma once

#include "read/corner_streams.hpp"
#include "read/indexed/buffered_faces.hpp"
#include "read/indexed/sorted_faces.hpp"
#include "read/indexed/vertex_store.hpp"
#include "read/mesh_reader.hpp"
#include "read/polygons/polygon_cutter.hpp"

#include <algorithm>
#include <cstdint>
#include <deque>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

namespace winnow {

// Positions and attributes are those of a VertexStore, which the derived class fills before
// anything is asked. Faces are numbers of vertices, given by the derived class; where they jump
// over more vertices than memory has room for, which a sample tells when faces are read for the
// first time, their vertices are brought together in scratch.
class IndexedReader : public MeshReader {
 public:
  IndexedReader(Job& job, std::unique_ptr<ByteSource> source, const ReaderMemory& memory,
                std::uint64_t vertex_memory)
      : job_(job),
        source_(std::move(source)),
        memory_(memory),
        vertices_(job, vertex_memory),
        cutter_([this] { job_.progress.check_cancelled(); }) {}

  void begin_positions(PassCorners corners) override;
  bool next_positions(RawBatch& batch) override;
  void decode_positions(const RawBatch& batch, FaceBatch& slice,
                        const PositionSink& sink) const override;
  std::optional<std::array<double, 3>> first_finite_position() override;
  std::vector<AttributeRange> attribute_ranges() override;
  void read_attributes(const PositionView& view, std::vector<double>& out) const override {
    vertices_.read_attributes(view.first, view.count, out);
  }

  void begin_faces() final;
  bool next_faces(RawBatch& batch) final;
  void decode_faces(const RawBatch& batch, FaceBatch& slice, const FaceSink& given) const final;

  void release_memory() override;
  void check_whole() const override { source_->check_whole(); }
  [[nodiscard]] const std::string& name() const override { return source_->name(); }

 protected:
  // Asks whether to go on, and reserves what a batch of so many triangles takes where that is more
  // than the plan knows: one that has a large polygon.
  [[nodiscard]] RawBatch::Grow grow_batch() {
    return [this](std::uint64_t triangles) { reserve_for_batch(triangles); };
  }
  // The faces from the first on, again if faces_come_again().
  virtual void begin_indices() = 0;
  // The next batch of them, of at most `memory_.batch_faces`; its `first` is the caller's to know.
  virtual bool next_indices(RawBatch& batch) = 0;
  virtual void decode_indices(const RawBatch& batch, FaceBatch& slice, const FaceSink& sink) const;
  // The numbers of a batch's corners, three a face.
  virtual void corner_numbers(const RawBatch& batch, std::vector<std::uint32_t>& numbers) const;
  [[nodiscard]] virtual bool faces_come_again() const = 0;
  // Some faces from somewhere, the first for 0, the last for 1; false where they can only be read
  // in order. begin_indices() follows.
  virtual bool sample_indices(double /*place*/, RawBatch& /*batch*/) { return false; }
  [[nodiscard]] std::uint64_t sample_begin(double place, std::uint64_t faces) const {
    const std::uint64_t last = faces - std::min<std::uint64_t>(faces, memory_.batch_faces);
    return std::min(last, static_cast<std::uint64_t>(place * static_cast<double>(last)));
  }

  Job& job_;
  std::unique_ptr<ByteSource> source_;
  ReaderMemory memory_;
  VertexStore vertices_;

 private:
  // Begins the faces, and sorts them or brings their vertices together where that is worth it.
  void begin_first_time();
  // What goes for both: they take in the faces from the first on, by take_in(next).
  void take_in(const std::function<void(const NextFaces&)>& build);
  void bring_together(const CornerStreams::Plan& plan);
  void sort(const SortedFaces::Plan& plan);
  bool next_of_source(RawBatch& batch);
  void cut_polygons(RawBatch& batch);
  void reserve_for_batch(std::uint64_t triangles);
  void to_indices(RawBatch& batch) const;

  std::uint64_t next_position_ = 0;
  std::uint64_t next_face_ = 0;
  PolygonCutter cutter_;
  Reservation large_polygon_;
  std::uint64_t largest_batch_ = 0;  // triangles
  std::uint64_t crossed_ = 0;  // polygons that cannot be cut, in the first pass over the faces
  bool faces_read_ = false;    // all of them, once
  bool sampled_ = false;
  std::deque<RawBatch> held_;               // read for the sample, and to be given out first
  std::unique_ptr<BufferedFaces> kept_;     // those that do not come again
  std::unique_ptr<CornerStreams> streams_;  // where faces jump
  std::unique_ptr<SortedFaces>
      sorted_;  // where only the next face is far away, and any order will do
};

}  // namespace winnow
