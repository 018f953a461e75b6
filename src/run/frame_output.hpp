// Where the frames of a simplified sequence go: a file each, one file that plays, or memory.
#pragma once

#include <winnow/sequence.hpp>

#include "base/morph_clip.hpp"
#include "io/byte_sink.hpp"
#include "io/job.hpp"
#include "mesh/stored_mesh.hpp"
#include "write/mesh_encoder.hpp"

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace winnow {

class FrameOutput {
 public:
  virtual ~FrameOutput() = default;
  [[nodiscard]] virtual const MeshEncoder& encoder() const = 0;
  [[nodiscard]] virtual std::string format() const = 0;
  // Frames in their order. `mesh` has other vertices at the next one. Returns what names the file
  // that it wrote, until name_files() and then on (see ByteSink); empty where it wrote none.
  virtual std::string write(std::size_t frame, const StoredMesh& mesh, const MeshShape& shape) = 0;
  // Behind the last, with the same mesh: a file of all frames.
  virtual std::string complete(StoredMesh& mesh) = 0;
  // Files that were written get their names.
  virtual void name_files() = 0;
  [[nodiscard]] virtual std::uint64_t bytes() const = 0;  // of all frames, before compression
};

// What is there already.
struct FilesThere {
  std::function<bool(std::size_t number, const std::string& name)> own;  // this run wrote it before
  const char* way_out = ByteSink::by_force;                              // of the others
};

// All files stay, or none.
std::unique_ptr<FrameOutput> frames_to_files(Job& job, std::vector<std::string> names,
                                             const SequenceOptions& options,
                                             const FilesThere& there);

// One GLB with a morph target for each frame but the first. `clips`: how it plays, for as many
// targets; without any one frame after the other.
std::unique_ptr<FrameOutput> frames_to_glb(Job& job, const std::string& name,
                                           std::vector<MorphClip> clips,
                                           const SequenceOptions& options, const FilesThere& there);
// Whether a name is of such a file.
bool holds_all_frames(const std::string& name, const SequenceOptions& options);

std::unique_ptr<FrameOutput> frames_to_sink(Job& job, FrameSink& sink,
                                            const SequenceOptions& options);

}  // namespace winnow
