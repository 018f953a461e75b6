// Clustering forgets which faces touch. Where that damaged the surface, cells are split until it no
// longer does.
#pragma once

#include "cluster/clusterer.hpp"
#include "io/job.hpp"
#include "read/mesh_reader.hpp"

#include <cstdint>
#include <memory>
#include <optional>

namespace winnow {

struct SafeMesh {
  ClusterResult result;
  SplitCells cells;
  unsigned shift = 0;  // keys of vertices are names of cells without so many of the lowest bits
};

// How the budget is divided for it, of what clustering has.
ClusterMemory safe_memory(ClusterMemory memory);

// `coarse`: what clustering with `settings` left of the faces in `box`, so many in all. `open`: the
// keys of cells that boundaries pass through (cluster/open_cells.hpp), which then keep all of their
// vertices to the bit; null where they may move a little. Nothing where so many cells are damaged
// that all faces are to be refined instead, or where damage does not go although cells cannot be
// split any more.
std::optional<SafeMesh> without_damage(Job& job, MeshReader& reader,
                                       const ClusterSettings& settings, const ClusterMemory& memory,
                                       const Box& box, std::uint64_t faces, ClusterResult coarse,
                                       std::unique_ptr<Spool> open);

}  // namespace winnow
