#include "run/frame_output.hpp"

#include <winnow/error.hpp>

#include "base/text.hpp"
#include "io/byte_sink.hpp"
#include "run/result_sink.hpp"
#include "run/write_blocks.hpp"
#include "run/write_mesh.hpp"
#include "write/formats.hpp"

#include <utility>

#include <sys/stat.h>

namespace winnow {

namespace {

class FrameFiles final : public FrameOutput {
 public:
  FrameFiles(Job& job, std::vector<std::string> names, const SequenceOptions& options,
             const FilesThere& there)
      : job_(job),
        names_(std::move(names)),
        format_(format_written(options.to, names_.front(), options.encoding)),
        way_out_(there.way_out),
        encoder_(make_encoder(options.to, names_.front(), options.encoding)),
        packing_(reserve_block(job, *encoder_, false)) {
    if (options.target.faces()) (void)encoder_->header({.faces = *options.target.faces()});
    for (const std::string& name : names_) {
      replaces_.push_back(options.force || there.own(replaces_.size(), name));
      struct stat status {};
      if (::stat(name.c_str(), &status) != 0) continue;
      if (!S_ISREG(status.st_mode))
        throw Error(ErrorKind::usage, "'" + name + "' is no regular file; a frame needs one");
      if (!replaces_.back()) throw Error(ErrorKind::usage, "'" + name + "' exists; " + way_out_);
      job.written_over.push_back(FileNumber::of(status));
    }
  }
  FrameFiles(const FrameFiles&) = delete;
  FrameFiles& operator=(const FrameFiles&) = delete;
  ~FrameFiles() override {
    if (complete_) return;
    for (const auto& sink : written_) sink->take_back();
  }

  [[nodiscard]] const MeshEncoder& encoder() const override { return *encoder_; }
  [[nodiscard]] std::string format() const override { return format_; }
  std::string write(std::size_t frame, const StoredMesh& mesh, const MeshShape& shape) override {
    const auto& sink = written_.emplace_back(
        std::make_unique<ByteSink>(job_, names_[frame], replaces_[frame], way_out_));
    write_mesh(job_, StoredOutput(mesh), shape, *encoder_, *sink);
    sink->flush_and_sync();
    bytes_ += sink->written();
    return sink->identity();
  }
  std::string complete(StoredMesh& /*mesh*/) override {
    complete_ = true;
    return {};
  }
  void name_files() override {
    for (; named_ < written_.size(); ++named_) {
      written_[named_]->finish_for_now();
      written_[named_]->release();
    }
  }
  [[nodiscard]] std::uint64_t bytes() const override { return bytes_; }

 private:
  Job& job_;
  std::vector<std::string> names_;
  std::string format_;
  std::vector<bool> replaces_;  // of each name whether a file that has it may go
  const char* way_out_;
  std::unique_ptr<MeshEncoder> encoder_;
  Reservation packing_;
  std::vector<std::unique_ptr<ByteSink>> written_;
  std::size_t named_ = 0;  // of these
  bool complete_ = false;
  std::uint64_t bytes_ = 0;
};

class FrameMeshes final : public FrameOutput {
 public:
  FrameMeshes(Job& job, FrameSink& sink, const SequenceOptions& options)
      : job_(job), sink_(sink), encoder_(make_encoder(Format::ply, {}, options.encoding)) {
    encoding_.encoding = options.encoding;
  }

  [[nodiscard]] const MeshEncoder& encoder() const override { return *encoder_; }
  [[nodiscard]] std::string format() const override { return "memory"; }
  std::string write(std::size_t frame, const StoredMesh& mesh, const MeshShape& shape) override {
    Mesh out;
    bytes_ += MemorySink(job_, out, encoding_).write(StoredOutput(mesh), shape);
    sink_.take(frame, std::move(out));
    return {};
  }
  std::string complete(StoredMesh& /*mesh*/) override { return {}; }
  void name_files() override {}
  [[nodiscard]] std::uint64_t bytes() const override { return bytes_; }

 private:
  Job& job_;
  FrameSink& sink_;
  SimplifyOptions encoding_;
  std::unique_ptr<MeshEncoder> encoder_;
  std::uint64_t bytes_ = 0;
};

}  // namespace

std::unique_ptr<FrameOutput> frames_to_files(Job& job, std::vector<std::string> names,
                                             const SequenceOptions& options,
                                             const FilesThere& there) {
  return std::make_unique<FrameFiles>(job, std::move(names), options, there);
}

std::unique_ptr<FrameOutput> frames_to_sink(Job& job, FrameSink& sink,
                                            const SequenceOptions& options) {
  return std::make_unique<FrameMeshes>(job, sink, options);
}

}  // namespace winnow
