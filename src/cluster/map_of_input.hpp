// Where each vertex of the input went: its vertex in the mesh that was made of it.
#pragma once

#include "base/vector.hpp"
#include "io/job.hpp"
#include "io/spool.hpp"
#include "mesh/vertex_map.hpp"
#include "read/mesh_reader.hpp"

#include <cstdint>
#include <functional>
#include <memory>

namespace winnow {

// Finds the vertex of a mesh that stands for a position. For one thread.
class VertexFinder {
 public:
  virtual ~VertexFinder() = default;
  virtual Destination find(const Point& position) = 0;
};
using MakeFinder = std::function<std::unique_ptr<VertexFinder>()>;

// Of all vertices of the input, about so many, in its order; without vertices of its own the three
// corners of each face are its vertices. Those that no good face has went nowhere. `faces` gives
// the good faces, `positions` the same input as it was clustered or welded: they may be one reader.
// Each is read once. Keeps at most `memory` bytes of the result in memory.
std::unique_ptr<Spool> map_of_input(Job& job, MeshReader& faces, MeshReader& positions,
                                    std::uint64_t vertices, const MakeFinder& make_finder,
                                    std::uint64_t memory);

}  // namespace winnow
