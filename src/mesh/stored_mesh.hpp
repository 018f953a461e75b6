// A mesh of any size, in memory or in scratch: what passes from stage to stage.
#pragma once

#include "base/rounding.hpp"
#include "io/spool.hpp"
#include "mesh/face_vertices.hpp"
#include "mesh/vertex_index.hpp"

#include <cstdint>
#include <memory>
#include <optional>

namespace winnow {

// Vertices come in the order of their keys. Faces begin with their lowest vertex, and come in the
// order of that.
struct StoredMesh {
  std::unique_ptr<VertexIndex> vertices;
  // Of each vertex what collapsing has to know of it: the Quadric of its cell, or what
  // Decimation::save() wrote. None where nothing is known.
  std::unique_ptr<Spool> state;
  std::unique_ptr<Spool> attributes;  // of each vertex its numbers, doubles; none where it has none
  std::unique_ptr<Spool> faces;       // FaceVertices
  std::uint64_t face_count = 0;
  std::optional<CoordinateRounding> rounding{};  // of the input's positions; only where welded
};

}  // namespace winnow
