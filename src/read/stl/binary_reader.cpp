// Binary STL: 80 bytes of anything, a 32-bit count, 50 bytes a face.
#include "read/stl/reader.hpp"

#include <array>
#include <cstring>
#include <string_view>

namespace winnow {

namespace {

class BinaryStlReader final : public StlReader {
 public:
  BinaryStlReader(Job& job, std::unique_ptr<ByteSource> source, const ReaderMemory& memory,
                  const StlHead& head)
      : StlReader(job, std::move(source), memory), declared_(head.declared), exact_(head.exact) {
    facts_ = facts_of(head);
    if (!source_->compression().empty()) facts_.format += ", " + source_->compression();
    const Block header = source_->take(stl_header_bytes);
    const std::string_view text(reinterpret_cast<const char*>(header.bytes.data()),
                                header.bytes.size());
    colors_ = text.substr(0, 80).find("COLOR=") != std::string_view::npos;
  }

  void begin_faces() override {
    if (source_->position() != stl_header_bytes && source_->seekable()) {
      source_->seek(stl_header_bytes);
      next_face_ = 0;
    }
  }

  bool read_faces(RawBatch& batch) override {
    batch = {};
    batch.first = next_face_;
    batch.block = source_->take(memory_.batch_faces * stl_face_bytes);
    batch.count = batch.block.bytes.size() / stl_face_bytes;
    next_face_ += batch.count;
    const std::size_t rest = batch.block.bytes.size() - batch.count * stl_face_bytes;
    if (batch.count == 0) {
      note_end(rest);
    } else {
      source_->give_back(rest);
    }
    return batch.count > 0;
  }

  void decode_faces(const RawBatch& batch, FaceBatch& slice, const FaceSink& sink) const override {
    const std::byte* record = batch.block.bytes.data() + 12;  // behind the face's normal
    slice.status.fill(FaceStatus::good);
    slice.all_good = true;
    slice.single = true;
    std::uint16_t attributes = 0;
    for (std::uint64_t from = 0; from < batch.count; from += FaceBatch::capacity) {
      slice.count = std::min<std::uint64_t>(FaceBatch::capacity, batch.count - from);
      slice.first = batch.first + from;
      for (std::size_t i = 0; i < slice.count; ++i, record += stl_face_bytes) {
        std::array<float, 9> corners;
        std::memcpy(corners.data(), record, sizeof corners);
        for (std::size_t corner = 0; corner < 3; ++corner) {
          for (std::size_t axis = 0; axis < 3; ++axis)
            slice.single_position[corner][axis][i] = corners[3 * corner + axis];
        }
        std::uint16_t word = 0;
        std::memcpy(&word, record + sizeof corners, sizeof word);
        attributes |= word;
      }
      sink(slice);
    }
    batch.block.check_intact(source_->name());
    if ((attributes & valid_color) != 0) colors_ = true;
  }

  // Without the detour over faces: passes over positions are bound by nothing but this.
  void decode_positions(const RawBatch& batch, FaceBatch& slice,
                        const PositionSink& sink) const override {
    const std::byte* record = batch.block.bytes.data() + 12;
    const unsigned corners = corners_ == PassCorners::all ? 3 : 1;
    for (std::uint64_t from = 0; from < batch.count; from += FaceBatch::capacity) {
      const std::size_t count = std::min<std::uint64_t>(FaceBatch::capacity, batch.count - from);
      for (unsigned corner = 0; corner < corners; ++corner) {
        auto& [x, y, z] = slice.position[corner];
        for (std::size_t i = 0; i < count; ++i) {
          std::array<float, 3> xyz;
          std::memcpy(xyz.data(), record + i * stl_face_bytes + corner * sizeof xyz, sizeof xyz);
          x[i] = xyz[0];
          y[i] = xyz[1];
          z[i] = xyz[2];
        }
        sink({{x.data(), y.data(), z.data()}, count, batch.first + from, corner, true});
      }
      record += count * stl_face_bytes;
    }
    batch.block.check_intact(source_->name());
  }

 private:
  void note_end(std::size_t rest) {
    bytes_seen_ = source_->position();
    if (noted_) return;
    noted_ = true;
    if (!is_stl_count(declared_, next_face_)) {
      if (exact_) refuse_stl_count(source_->name(), declared_, next_face_);
      job_.note("the STL header says " + grouped(declared_) + " faces; there are " +
                grouped(next_face_));
    }
    if (rest > 0)
      job_.note("the last " + std::to_string(rest) + " bytes are no whole face and were left out");
  }

  static constexpr std::uint16_t valid_color = 0x8000;

  std::uint64_t declared_;
  bool exact_;
};

}  // namespace

std::unique_ptr<MeshReader> make_binary_stl_reader(Job& job, std::unique_ptr<ByteSource> source,
                                                   const ReaderMemory& memory,
                                                   const StlHead& head) {
  return std::make_unique<BinaryStlReader>(job, std::move(source), memory, head);
}

}  // namespace winnow
