// The faces round a vertex in their order, where they are one fan.
#pragma once

#include "decimate/tile_mesh.hpp"

#include <cstddef>
#include <span>
#include <utility>
#include <vector>

namespace winnow {

// What the costs ask of a vertex takes the square of its faces, or more: vertices with more than these stay
// until their neighbours have gone.
inline constexpr std::size_t most_faces_of_fan = 64;

class Fan {
 public:
  // Whether the faces of `v` are one fan: a disk round it, or half of one at a border. Otherwise the mesh is
  // no surface there, or the vertex has no faces or too many.
  bool find(const TileMesh& mesh, VertexNumber v);

  // Whether it goes all the way round. An open one begins and ends at a border.
  [[nodiscard]] bool closed() const { return closed_; }
  // In order, whichever way round.
  [[nodiscard]] std::span<const VertexNumber> neighbours() const { return ring_; }
  // Their positions seen from the vertex.
  [[nodiscard]] std::span<const Point> seen() const { return seen_; }

 private:
  bool extend();

  std::vector<VertexNumber> ring_;
  std::vector<Point> seen_;
  std::vector<std::pair<VertexNumber, VertexNumber>> rim_;  // the edges across from the vertex
  bool closed_ = false;
};

// Face i of a fan of `neighbours`, of which a closed one has as many, is between neighbours i and i + 1.
inline std::size_t faces_of_fan(std::size_t neighbours, bool closed) {
  return closed ? neighbours : neighbours - 1;
}
inline std::size_t next_in_fan(std::size_t i, std::size_t neighbours) {
  return i + 1 == neighbours ? 0 : i + 1;
}

}  // namespace winnow
