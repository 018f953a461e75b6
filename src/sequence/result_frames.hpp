// The frames of a simplified sequence as meshes to be written, one after the other.
#pragma once

#include "io/job.hpp"
#include "mesh/stored_mesh.hpp"

#include <cstddef>
#include <cstdint>
#include <functional>

namespace winnow {

// The frames from `first` on. `mesh`: what refine() left of a sequence; its vertices stay those of
// the last frame. Holds as many frames at once as `memory` has room for, and reads the mesh once
// for each so many. Vertices get the normals of their frame, and carry its numbers alone.
void for_each_result_frame(Job& job, StoredMesh& mesh, std::size_t frames, std::size_t first,
                           std::uint64_t memory,
                           const std::function<void(std::size_t frame)>& each);

}  // namespace winnow
