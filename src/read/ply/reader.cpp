// PLY, by Greg Turk's description of 1994 and what programs have made of it since.
#include "read/indexed/reader.hpp"

#include <winnow/error.hpp>

#include "base/memory_shares.hpp"
#include "base/text.hpp"
#include "read/formats.hpp"
#include "read/indexed/buffered_faces.hpp"
#include "read/indexed/slices.hpp"
#include "read/ply/header_facts.hpp"
#include "read/ply/lists.hpp"
#include "read/ply/scalar.hpp"
#include "read/ply/values.hpp"
#include "read/ply/vertices.hpp"

#include <algorithm>
#include <cstring>
#include <optional>

namespace winnow {

namespace {

class PlyReader final : public IndexedReader {
 public:
  PlyReader(Job& job, std::unique_ptr<ByteSource> source, const ReaderMemory& memory,
            const AttributeRequest& wish)
      : IndexedReader(job, std::move(source), memory, memory.vertices) {
    header_ = read_ply_header(*source_);
    facts_ = ply_facts(header_);
    facts_.offer = available_attributes(header_);
    facts_.choice = choose_attributes(wish, facts_.offer, source_->name());
    if (!source_->compression().empty()) facts_.format += ", " + source_->compression();
    faces_ = find_faces(header_, source_->name());
    values_ = make_ply_values(*source_, header_.form);
    check_size();
    for (const PlyElement& element : header_.elements) {
      if (element.name == "vertex") {
        values_->sync();
        PlyVertices(job_, *source_, *values_, header_.form, facts_).read(element, vertices_);
        vertices_loaded_ = true;
        if (faces_.element == nullptr || buffered_faces_ != nullptr) break;
      } else if (&element == faces_.element) {
        if (vertices_loaded_) break;
        keep_faces();
      } else {
        skip_element(element);
      }
    }
    values_->sync();
    faces_offset_ = source_->position();
    if (faces_.element != nullptr && !vertices_loaded_) {
      throw Error(ErrorKind::bad_input,
                  "'" + source_->name() + "' has faces but no element 'vertex'");
    }
    facts_.polygons = !surely_triangles(header_, faces_, source_->size());
  }

  [[nodiscard]] std::uint64_t bytes() const override {
    return std::max(source_->position(), bytes_seen_);
  }

 protected:
  void begin_indices() override {
    if (faces_.element == nullptr) return;
    next_kept_ = 0;
    if (buffered_faces_ != nullptr) return;
    // The first time the source stands there already, and may not be seekable.
    if (source_->position() != faces_offset_ || lists_ != nullptr) {
      values_->sync();
      source_->seek(faces_offset_);
    }
    lists_ = std::make_unique<PlyLists>(*faces_.element, *faces_.list, *values_, faces_.strips);
  }

  bool next_indices(RawBatch& batch) override {
    if (faces_.element == nullptr) return false;
    if (buffered_faces_ != nullptr) {
      buffered_faces_->read(next_kept_, memory_.batch_faces, batch, grow_batch());
      next_kept_ += batch.count;
    } else if (!next_triangles(batch)) {
      // Some other polygon comes first; a few records on there may be triangles again.
      lists_->read(batch, memory_.batch_faces, grow_batch(),
                   triangle_stride() != 0 ? memory_.batch_faces / 4 : UINT64_MAX);
    }
    if (batch.count == 0) read_to_the_end();
    return batch.count > 0;
  }

  void decode_indices(const RawBatch& batch, FaceBatch& slice,
                      const FaceSink& sink) const override {
    if (!batch.indices.empty()) {
      slice_indices(batch, vertices_, slice, sink);
    } else if (header_.form == PlyForm::big_endian) {
      decode_triangles<true>(batch, slice, sink);
    } else {
      decode_triangles<false>(batch, slice, sink);
    }
  }

  void corner_numbers(const RawBatch& batch, std::vector<std::uint32_t>& numbers) const override {
    if (!batch.indices.empty()) return IndexedReader::corner_numbers(batch, numbers);
    const std::size_t stride = triangle_stride();
    const bool swapped = header_.form == PlyForm::big_endian;
    const std::byte* record = batch.block.bytes.data() + list_offset() + 1;
    numbers.resize(3 * batch.count);
    for (std::size_t i = 0; i < batch.count; ++i, record += stride) {
      for (std::size_t corner = 0; corner < 3; ++corner)
        numbers[3 * i + corner] = load<std::uint32_t>(record + 4 * corner, swapped);
    }
  }

  [[nodiscard]] bool faces_come_again() const override {
    return buffered_faces_ != nullptr || source_->seekable();
  }

  // Only where faces stand in records of one size, all triangles.
  bool sample_indices(double place, RawBatch& batch) override {
    if (faces_.element == nullptr) return false;
    if (buffered_faces_ != nullptr) {
      buffered_faces_->read(buffered_faces_->begin_of(sample_begin(place, buffered_faces_->size())),
                            memory_.batch_faces, batch);
      return true;
    }
    const std::size_t stride = triangle_stride();
    if (stride == 0 || !source_->seekable()) return false;
    values_->sync();
    source_->seek(faces_offset_ + sample_begin(place, faces_.element->count) * stride);
    const std::size_t wanted =
        std::min<std::uint64_t>(triangles_at_once(stride), faces_.element->count);
    return take_triangles(stride, wanted, batch) == wanted;
  }

 private:
  // A header that promises more than the file can hold is refused first.
  void check_size() const {
    if (!source_->size()) return;
    const std::uint64_t rest = *source_->size() - source_->position();
    std::uint64_t left = rest + 1;  // the last ASCII line may lack its end
    for (const PlyElement& element : header_.elements) {
      // In ASCII every value takes at least a digit and a separator.
      const std::size_t record =
          header_.form == PlyForm::ascii ? 2 * element.properties.size() : element.smallest_size();
      if (record != 0 && element.count > left / record) {
        throw Error(ErrorKind::bad_input,
                    "'" + source_->name() + "' is too short for its header: element '" +
                        element.name + "' says " + grouped(element.count) + ", but only " +
                        human_bytes(rest) +
                        " follow the header; it was cut short, or the count is wrong");
      }
      left -= element.count * record;
    }
  }

  void skip_element(const PlyElement& element) {
    if (element.properties.empty()) return;
    for (std::uint64_t i = 0; i < element.count; ++i) {
      values_->now_reading(element.name.c_str(), i);
      for (const PlyProperty& property : element.properties) skip_property(*values_, property);
      if (i % 4096 == 0) job_.progress.check_cancelled();
    }
  }

  // Faces that stand before the vertices wait in scratch.
  void keep_faces() {
    job_.progress.begin("keep faces", faces_.element->count, "faces");
    buffered_faces_ =
        std::make_unique<BufferedFaces>(job_, share::reading::faces_first(memory_.vertices));
    PlyLists lists(*faces_.element, *faces_.list, *values_, faces_.strips);
    for (;;) {
      RawBatch batch;
      lists.read(batch, 4096, grow_batch());
      if (batch.count == 0) break;
      buffered_faces_->add(batch);
      job_.progress.advance(batch.count);
    }
    buffered_faces_->finish();
  }

  [[nodiscard]] std::size_t triangle_stride() const {
    return winnow::triangle_stride(header_, faces_);
  }

  [[nodiscard]] std::size_t list_offset() const {
    std::size_t offset = 0;
    for (const PlyProperty& property : faces_.element->properties) {
      if (&property == faces_.list) break;
      offset += size_of(property.type);
    }
    return offset;
  }

  // A stretch of records that are all triangles, undecoded; false if the next record is none.
  bool next_triangles(RawBatch& batch) {
    const std::size_t stride = triangle_stride();
    const std::uint64_t left = faces_.element->count - lists_->records();
    if (stride == 0 || left == 0 || !lists_->between_records()) return false;
    values_->sync();
    lists_->pass_over(
        take_triangles(stride, std::min<std::uint64_t>(triangles_at_once(stride), left), batch));
    return batch.count > 0;
  }

  // No more bytes than the plan has room for, however many properties a face has.
  [[nodiscard]] std::size_t triangles_at_once(std::size_t stride) const {
    return std::clamp<std::size_t>(memory_.batch_faces * 72 / stride, 1, memory_.batch_faces);
  }

  // As many of the wanted records as are triangles; returns how many.
  std::size_t take_triangles(std::size_t stride, std::size_t wanted, RawBatch& batch) {
    batch.block = source_->take(wanted * stride);
    const std::size_t whole = batch.block.bytes.size() / stride;
    const std::byte* count = batch.block.bytes.data() + list_offset();
    // The file is met here first, and processors do not look ahead into the next page.
    std::size_t triangles = 0;
    for (; triangles < whole && count[triangles * stride] == std::byte{3}; ++triangles)
      __builtin_prefetch(count + triangles * stride + 1024);
    source_->give_back(batch.block.bytes.size() - triangles * stride);
    batch.block.bytes = batch.block.bytes.first(triangles * stride);
    batch.count = triangles;
    return triangles;
  }

  template <bool Swapped>
  void decode_triangles(const RawBatch& batch, FaceBatch& slice, const FaceSink& sink) const {
    std::array<std::array<std::uint32_t, FaceBatch::capacity>, 3> index;
    const std::size_t stride = triangle_stride();
    const std::byte* record = batch.block.bytes.data() + list_offset() + 1;
    slice.status.fill(FaceStatus::good);
    for (std::uint64_t from = 0; from < batch.count; from += FaceBatch::capacity) {
      slice.count = std::min<std::uint64_t>(FaceBatch::capacity, batch.count - from);
      slice.first = batch.first + from;
      if (!slice.all_good) slice.status.fill(FaceStatus::good);
      slice.all_good = true;
      for (std::size_t i = 0; i < slice.count; ++i, record += stride) {
        for (std::size_t corner = 0; corner < 3; ++corner) {
          index[corner][i] = load<std::uint32_t>(record + 4 * corner, Swapped);
        }
      }
      gather_checked(vertices_, {index[0].data(), index[1].data(), index[2].data()}, slice);
      sink(slice);
    }
  }

  // A pipe's writer must not be cut off by elements behind the faces.
  void read_to_the_end() {
    values_->sync();
    if (!source_->seekable()) {
      while (!source_->take(std::size_t{1} << 20).bytes.empty()) job_.progress.check_cancelled();
    }
    bytes_seen_ = source_->size().value_or(source_->position());
  }

  PlyHeader header_;
  PlyFaces faces_;
  std::unique_ptr<PlyValues> values_;
  bool vertices_loaded_ = false;
  std::uint64_t faces_offset_ = 0;
  std::unique_ptr<PlyLists> lists_;
  std::unique_ptr<BufferedFaces> buffered_faces_;
  std::uint64_t next_kept_ = 0;
  std::uint64_t bytes_seen_ = 0;
};

std::unique_ptr<MeshReader> open_ply(Job& job, std::unique_ptr<ByteSource> source,
                                     const ReaderMemory& memory, const AttributeRequest& wish,
                                     bool /*asked*/) {
  return std::make_unique<PlyReader>(job, std::move(source), memory, wish);
}

void probe_ply(Job& /*job*/, ByteSource& source, bool /*asked*/, InputProbe& probe) {
  const PlyHeader header = read_ply_header(source);
  source.give_back(header.bytes);
  probe.facts = ply_facts(header);
  probe.facts.offer = available_attributes(header);
  const PlyElement* vertex = header.find("vertex");
  probe.vertices_buffered =
      vertex != nullptr && (header.form == PlyForm::ascii || !vertex->fixed_size());
  if (vertex != nullptr && !probe.vertices_buffered) probe.vertex_bytes = vertex->smallest_size();
  const PlyFaces faces = find_faces(header, source.name());
  probe.facts.polygons = !surely_triangles(header, faces, source.size());
  probe.faces_buffered = vertex != nullptr && faces.element != nullptr && faces.element < vertex;
}

}  // namespace

const InputFormat ply_input{
    .reading = Reading::vertices, .open = open_ply, .probe = probe_ply, .certain = begins_like_ply};

}  // namespace winnow
