// Frames wait until all are there: their boxes come first in the file.
#include <winnow/error.hpp>

#include "base/memory_shares.hpp"
#include "base/text.hpp"
#include "io/byte_sink.hpp"
#include "io/spool_records.hpp"
#include "mesh/vertex_index.hpp"
#include "read/formats.hpp"
#include "run/frame_output.hpp"
#include "run/write_mesh.hpp"
#include "sequence/frame_names.hpp"
#include "write/formats.hpp"
#include "write/moving_glb.hpp"

#include <algorithm>
#include <functional>
#include <optional>
#include <span>
#include <utility>

namespace winnow {

namespace {

constexpr std::size_t most_frames = 1 << 16;  // then places of weights are no longer 32 bits

void check(const SequenceOptions& options) {
  const auto refuse = [](const std::string& what) {
    throw Error(ErrorKind::usage, what + "; name a file for each frame, like 'small-{frame}.glb'");
  };
  if (options.per_frame > 0)
    refuse("frames with faces of their own, as `per_frame` makes them, do not fit into one GLB");
  if (options.encoding.compress != Compression::none)
    refuse("a GLB that moves cannot be written with `compress`");
  if (options.encoding.quantize) refuse("a GLB that moves cannot be written with `quantize`");
}

class FrameGlb final : public FrameOutput {
 public:
  FrameGlb(Job& job, const std::string& name, std::vector<MorphClip> clips,
           const SequenceOptions& options, const FilesThere& there)
      : job_(job),
        encoding_(options.encoding),
        clips_(std::move(clips)),
        encoder_(make_encoder(Format::gltf, name, encoding_)),
        format_(format_written(Format::gltf, name, encoding_)),
        sink_(job, name, options.force || there.own(0, name), there.way_out) {
    sink_.refuse_terminal();
  }

  [[nodiscard]] const MeshEncoder& encoder() const override { return *encoder_; }
  [[nodiscard]] std::string format() const override { return format_; }

  std::string write(std::size_t frame, const StoredMesh& mesh, const MeshShape& shape) override {
    if (frame == most_frames)
      throw Error(ErrorKind::usage, "one GLB holds at most " + grouped(most_frames) +
                                        " frames; name a file for each, like 'small-{frame}.glb'");
    if (!frames_) {
      frames_.emplace(job_, share::left::added_mesh(job_.budget.left()));
      if (!shape.attributes.empty())
        values_.emplace(job_, share::left::added_mesh(job_.budget.left()));
      shape_ = shape;
      first_ = shape.box;
    }
    shape_.box.add(shape.box);
    mesh.vertices->records().for_each_part(sizeof(IndexedVertex),
                                           [&](std::span<const std::byte> part) {
                                             job_.progress.check_cancelled();
                                             frames_->append(part);
                                           });
    if (values_) {
      mesh.attributes->for_each_part(sizeof(double), [&](std::span<const std::byte> part) {
        job_.progress.check_cancelled();
        values_->append(part);
      });
    }
    ++count_;
    return {};
  }

  std::string complete(StoredMesh& mesh) override {
    frames_->finish();
    if (values_) values_->finish();
    const std::size_t targets = count_ - 1;
    if (clips_.empty() && targets > 0) clips_.push_back(one_after_another(targets));
    const auto glb = make_moving_glb(encoding_, shape_, first_, targets, std::move(clips_));
    job_.progress.begin("write", 2 * targets * shape_.vertices, "vertices");
    for_each_target([&](std::size_t target, std::span<const MeshVertex> first,
                        std::span<const MeshVertex> own) { glb->measure(target, first, own); });
    mesh.vertices = first_vertices();
    if (values_) mesh.attributes = first_values();
    write_mesh(job_, StoredOutput(mesh), shape_, glb->encoder(), sink_);
    std::vector<std::byte> bytes;
    for_each_target([&](std::size_t /*target*/, std::span<const MeshVertex> first,
                        std::span<const MeshVertex> own) {
      bytes.clear();
      glb->append_target(first, own, bytes);
      sink_.write(bytes);
    });
    bytes.clear();
    glb->append_clips(bytes);
    sink_.write(bytes);
    sink_.flush_and_sync();
    return sink_.identity();
  }

  void name_files() override { sink_.finish(); }

  [[nodiscard]] std::uint64_t bytes() const override { return sink_.written(); }

 private:
  using EachTarget = std::function<void(std::size_t target, std::span<const MeshVertex> first,
                                        std::span<const MeshVertex> own)>;

  [[nodiscard]] FinishedVertices vertices(std::size_t frame, std::uint64_t first,
                                          std::size_t count) const {
    const std::uint64_t from = frame * shape_.vertices + first;
    return finished_vertices(*frames_, values_ ? &*values_ : nullptr, shape_, from, count);
  }

  // Part by part, target by target.
  void for_each_target(const EachTarget& each) {
    for (std::size_t frame = 1; frame < count_; ++frame) {
      for (std::uint64_t v = 0; v < shape_.vertices; v += chunk_records) {
        const std::size_t part = std::min<std::uint64_t>(chunk_records, shape_.vertices - v);
        each(frame - 1, vertices(0, v, part).vertices, vertices(frame, v, part).vertices);
        job_.progress.advance(part);
      }
    }
  }

  [[nodiscard]] std::unique_ptr<VertexIndex> first_vertices() {
    auto out = std::make_unique<VertexIndex>(job_, share::left::added_mesh(job_.budget.left()));
    for (std::uint64_t v = 0; v < shape_.vertices; v += chunk_records)
      out->append(read_records<IndexedVertex>(
          *frames_, v, std::min<std::uint64_t>(chunk_records, shape_.vertices - v)));
    out->finish();
    return out;
  }

  [[nodiscard]] std::unique_ptr<Spool> first_values() {
    const std::size_t each = shape_.attributes.size();
    auto out = std::make_unique<Spool>(job_, share::left::added_mesh(job_.budget.left()));
    for (std::uint64_t v = 0; v < shape_.vertices; v += chunk_records) {
      const std::uint64_t part = std::min<std::uint64_t>(chunk_records, shape_.vertices - v);
      append_records<double>(*out, read_records<double>(*values_, v * each, part * each));
    }
    out->finish();
    return out;
  }

  Job& job_;
  Encoding encoding_;
  std::vector<MorphClip> clips_;
  std::unique_ptr<MeshEncoder> encoder_;  // of one frame
  std::string format_;
  ByteSink sink_;
  std::optional<Spool> frames_;  // their vertices, frame after frame
  std::optional<Spool> values_;  // what these carry
  std::size_t count_ = 0;
  MeshShape shape_;  // its box holds all frames
  Box first_;
};

}  // namespace

bool holds_all_frames(const std::string& name, const SequenceOptions& options) {
  if (name.find(frame_placeholder) != std::string::npos) return false;
  const Format format = options.to == Format::automatic ? format_called(name) : options.to;
  return format == Format::gltf;
}

std::unique_ptr<FrameOutput> frames_to_glb(Job& job, const std::string& name,
                                           std::vector<MorphClip> clips,
                                           const SequenceOptions& options,
                                           const FilesThere& there) {
  check(options);
  return std::make_unique<FrameGlb>(job, name, std::move(clips), options, there);
}

}  // namespace winnow
