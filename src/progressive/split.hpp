// The steps of a progressive mesh, from coarse to fine.
//
// A vertex is so many words of 32 bits: its position, then what it carries (vertex_words.hpp).
#pragma once

#include "mesh/face_vertices.hpp"

#include <array>
#include <cstdint>
#include <vector>

namespace winnow {

using Words = std::vector<std::uint32_t>;
// The other two corners of a face at a vertex, in its winding.
using FarEdge = std::array<std::uint32_t, 2>;

// Takes a collapse back: brings vertices back, hands faces over to the first of them, and brings
// faces back. New vertices get the next numbers in order.
struct Split {
  std::uint32_t anchor = no_number;  // the vertex that was kept; none where none was left
  bool moves = false;                // the anchor gets other words
  std::uint32_t new_vertices = 0;
  Words words;  // of the anchor, where it moves, then of the new ones
  // Faces at the anchor that become the first new vertex's: by their other corners, or by their
  // corners at the anchor in a SplitMesh, where these are known.
  std::vector<FarEdge> moved;
  std::vector<std::uint32_t> corners;
  // Or all corners at the anchor.
  struct Corner {
    std::uint32_t corner, moves;
  };
  std::vector<Corner> around;
  std::vector<FaceVertices> restored;  // faces that were gone

  // Keeps what it has allocated.
  void clear() {
    anchor = no_number;
    moves = false;
    new_vertices = 0;
    words.clear();
    moved.clear();
    corners.clear();
    around.clear();
    restored.clear();
  }
};

}  // namespace winnow
