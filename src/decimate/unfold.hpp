// Turns flipped faces over by moving their corners.
//
// A face is flipped if it faces away from the nearest part of the original surface. Edge collapse
// causes that where the surface is thin or has tiny handles: a vertex ends up on the wrong side of
// a sheet. Only the original tells which faces are flipped. By its neighbours, such a face looks
// like any face at a sharp edge.
#pragma once

#include "base/box.hpp"
#include "base/vector.hpp"
#include "decimate/tile_mesh.hpp"

#include <cstdint>
#include <span>
#include <vector>

namespace winnow {

// The surface that a simplified mesh stands for.
class ReferenceSurface {
 public:
  ReferenceSurface() = default;
  ReferenceSurface(const ReferenceSurface&) = delete;
  ReferenceSurface& operator=(const ReferenceSurface&) = delete;
  virtual ~ReferenceSurface() = default;

  // All faces whose boxes meet `box`, neighbours close to each other; none if there are very many.
  virtual std::vector<Triangle> faces_near(const Box& box) = 0;
};

struct Unfolded {
  std::vector<VertexNumber> moved;  // ascending, each once
  std::uint64_t tried = 0;          // moves
};

struct UnfoldRules {
  bool single = true;  // positions are rounded to floats
  // Looks at every face, not only at those that lie askew, and moves vertices at boundaries, too.
  bool thorough = false;
};

// Moves vertices in `positions` until fewer faces are flipped. No face becomes flipped unless more
// faces are turned over, and no face becomes a line. Vertices stay if they are locked, at an edge
// with more than two faces or, unless the rules say so, at a boundary.
Unfolded unfold(std::vector<Point>& positions, std::span<const FaceVertices> faces,
                std::span<const std::uint8_t> locked, const UnfoldRules& rules,
                ReferenceSurface& reference);

// Bytes in use at most, besides the mesh. `near`: the most faces that faces_near() gives.
std::uint64_t unfold_memory(std::uint64_t vertices, std::uint64_t faces, std::uint64_t near);

}  // namespace winnow
