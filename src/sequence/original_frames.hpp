// The frames that a sequence was read from, as references to unfold the result beside.
#pragma once

#include "io/checkpoint_directory.hpp"
#include "io/job.hpp"
#include "io/spool.hpp"
#include "mesh/vertex_index.hpp"

#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

namespace winnow {

// Positions frame after frame, of which those of some vertices are in the mesh.
struct OriginalFrames {
  std::unique_ptr<Spool> places;
  std::vector<bool> in_mesh;  // of each vertex of a frame

  // The mesh's vertices in a frame; `first`: in the first one.
  [[nodiscard]] std::unique_ptr<VertexIndex> vertices(Job& job, std::size_t frame,
                                                      const VertexIndex& first,
                                                      std::uint64_t memory) const;

  // In a checkpoint, where they stay until the run is done.
  void save(Job& job, CheckpointDirectory& checkpoint) const;
  static OriginalFrames load(Job& job, const CheckpointDirectory& checkpoint, std::uint64_t memory);
};

}  // namespace winnow
