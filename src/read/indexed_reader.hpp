// What readers of formats with shared vertices have in common.
#pragma once

#include "read/mesh_reader.hpp"
#include "read/vertex_store.hpp"

namespace winnow {

// Positions and attributes are those of a VertexStore, which the derived class fills before anything is
// asked.
class IndexedReader : public MeshReader {
 public:
  IndexedReader(Job& job, std::unique_ptr<ByteSource> source, const ReaderMemory& memory,
                std::uint64_t vertex_memory)
      : job_(job), source_(std::move(source)), memory_(memory), vertices_(job, vertex_memory) {}

  void begin_positions(PassCorners corners) override;
  bool next_positions(RawBatch& batch) override;
  void decode_positions(const RawBatch& batch, FaceBatch& slice, const PositionSink& sink) const override;
  std::optional<std::array<double, 3>> first_finite_position() override;
  std::vector<AttributeRange> attribute_ranges() override;
  void read_attributes(const PositionView& view, std::vector<double>& out) const override {
    vertices_.read_attributes(view.first, view.count, out);
  }

  void rest() override { vertices_.rest(); }
  void check_whole() const override { source_->check_whole(); }
  [[nodiscard]] const std::string& name() const override { return source_->name(); }

 protected:
  // Of facts_.choice.
  [[nodiscard]] std::vector<ScalarType> carried_types() const;

  Job& job_;
  std::unique_ptr<ByteSource> source_;
  ReaderMemory memory_;
  VertexStore vertices_;

 private:
  std::uint64_t next_position_ = 0;
};

}  // namespace winnow
