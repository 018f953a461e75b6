// A mesh that moves as one GLB: the first frame is the mesh, each further one a morph target, and
// animations play them.
#pragma once

#include "base/morph_clip.hpp"
#include "write/mesh_encoder.hpp"

#include <cstddef>
#include <memory>
#include <span>
#include <vector>

namespace winnow {

// A file is what encoder() makes of the first frame, then all of each target, then the clips.
class MovingGlb {
 public:
  virtual ~MovingGlb() = default;

  // Before anything else, for all vertices of each target: in the first frame and in its own.
  virtual void measure(std::size_t target, std::span<const MeshVertex> first,
                       std::span<const MeshVertex> own) = 0;

  [[nodiscard]] virtual const MeshEncoder& encoder() const = 0;
  virtual void append_target(std::span<const MeshVertex> first, std::span<const MeshVertex> own,
                             std::vector<std::byte>& out) const = 0;
  virtual void append_clips(std::vector<std::byte>& out) const = 0;
};

// `shape`: its box holds all frames. `first`: the box of the first one.
std::unique_ptr<MovingGlb> make_moving_glb(const Encoding& encoding, const MeshShape& shape,
                                           const Box& first, std::size_t targets,
                                           std::vector<MorphClip> clips);

}  // namespace winnow
