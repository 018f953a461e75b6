// The frames of a sequence as meshes to be read, one after the other.
#pragma once

#include <winnow/sequence.hpp>

#include "io/job.hpp"
#include "read/mesh_reader.hpp"
#include "read/morph_frames.hpp"

#include <cstddef>
#include <memory>
#include <string>
#include <vector>

namespace winnow {

class FrameReaders {
 public:
  virtual ~FrameReaders() = default;
  // The next frame; null behind the last.
  virtual std::unique_ptr<MeshReader> next(const ReaderMemory& memory) = 0;
  // The frame that next() gave last, once more.
  virtual std::unique_ptr<MeshReader> again(const ReaderMemory& memory) = 0;
  [[nodiscard]] virtual std::string name(std::size_t frame) const = 0;  // for messages
};

// `wish`: which attributes of vertices are read. Of morph targets; `frames` must stay.
std::unique_ptr<FrameReaders> frames_of_morphs(MorphFrames& frames, const std::string& name,
                                               AttributeRequest wish);

// `names` must stay.
std::unique_ptr<FrameReaders> frames_of_files(Job& job, const std::vector<std::string>& names,
                                              Format from, AttributeRequest wish);
// `source` must stay.
std::unique_ptr<FrameReaders> frames_of_source(Job& job, FrameSource& source,
                                               AttributeRequest wish);

}  // namespace winnow
