#include "sequence/frame_readers.hpp"

#include "io/byte_source.hpp"
#include "read/view_arrays.hpp"
#include "read/view_reader.hpp"

#include <utility>

namespace winnow {

namespace {

class FileFrames final : public FrameReaders {
 public:
  FileFrames(Job& job, const std::vector<std::string>& names, Format from, AttributeRequest wish)
      : job_(job), names_(names), from_(from), wish_(std::move(wish)) {}

  std::unique_ptr<MeshReader> next(const ReaderMemory& memory) override {
    if (begun_ == names_.size()) return nullptr;
    ++begun_;
    return again(memory);
  }
  std::unique_ptr<MeshReader> again(const ReaderMemory& memory) override {
    return open_reader(job_, open_source(job_, names_[begun_ - 1]), from_, Access::positions_first,
                       memory, wish_);
  }
  [[nodiscard]] std::string name(std::size_t frame) const override {
    return "'" + names_[frame] + "'";
  }

 private:
  Job& job_;
  const std::vector<std::string>& names_;
  Format from_;
  AttributeRequest wish_;
  std::size_t begun_ = 0;
};

class TargetFrames final : public FrameReaders {
 public:
  TargetFrames(MorphFrames& frames, std::string name, AttributeRequest wish)
      : frames_(frames), name_(std::move(name)), wish_(std::move(wish)) {}

  std::unique_ptr<MeshReader> next(const ReaderMemory& memory) override {
    if (begun_ == frames_.frames()) return nullptr;
    ++begun_;
    return again(memory);
  }
  std::unique_ptr<MeshReader> again(const ReaderMemory& memory) override {
    return frames_.open(begun_ - 1, memory, wish_);
  }
  [[nodiscard]] std::string name(std::size_t frame) const override {
    return "'" + name_ + "'" + (frame > 0 ? ", morph target " + std::to_string(frame) : "");
  }

 private:
  MorphFrames& frames_;
  std::string name_;
  AttributeRequest wish_;
  std::size_t begun_ = 0;
};

class ViewFrames final : public FrameReaders {
 public:
  ViewFrames(Job& job, FrameSource& source, AttributeRequest wish)
      : job_(job), source_(source), wish_(std::move(wish)) {}

  std::unique_ptr<MeshReader> next(const ReaderMemory& memory) override {
    view_ = {};
    if (!source_.next(view_)) return nullptr;
    check_view(view_);
    return again(memory);
  }
  std::unique_ptr<MeshReader> again(const ReaderMemory& memory) override {
    return open_view(job_, view_, memory, wish_);
  }
  [[nodiscard]] std::string name(std::size_t frame) const override {
    return "frame " + std::to_string(frame + 1);
  }

 private:
  Job& job_;
  FrameSource& source_;
  AttributeRequest wish_;
  MeshView view_;
};

}  // namespace

std::unique_ptr<FrameReaders> frames_of_files(Job& job, const std::vector<std::string>& names,
                                              Format from, AttributeRequest wish) {
  return std::make_unique<FileFrames>(job, names, from, std::move(wish));
}

std::unique_ptr<FrameReaders> frames_of_morphs(MorphFrames& frames, const std::string& name,
                                               AttributeRequest wish) {
  return std::make_unique<TargetFrames>(frames, name, std::move(wish));
}

std::unique_ptr<FrameReaders> frames_of_source(Job& job, FrameSource& source,
                                               AttributeRequest wish) {
  return std::make_unique<ViewFrames>(job, source, std::move(wish));
}

}  // namespace winnow
