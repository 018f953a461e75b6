// A mesh cut into tiles: ranges of its vertices, each under one prefix of their Morton keys.
#pragma once

#include "mesh/stored_mesh.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace winnow {

class Tiling {
 public:
  // Tiles of at most `tile_faces` faces and as many vertices: eighths of the lattice are cut into
  // eighths until they are small enough, and neighbours under one prefix joined while they are.
  // Only vertices that share one key cannot be told apart.
  Tiling(const StoredMesh& mesh, std::uint64_t tile_faces);

  [[nodiscard]] std::size_t tiles() const { return first_vertex_.size() - 1; }
  [[nodiscard]] std::uint64_t first_vertex(std::size_t tile) const { return first_vertex_[tile]; }
  [[nodiscard]] std::uint64_t first_face(std::size_t tile) const { return first_face_[tile]; }

  // A tile has its own vertices, and the faces whose lowest vertex is one.
  [[nodiscard]] std::size_t tile_of(std::uint64_t vertex) const {
    return static_cast<std::size_t>(
               std::upper_bound(first_vertex_.begin(), first_vertex_.end(), vertex) -
               first_vertex_.begin()) -
           1;
  }

 private:
  // Behind the last tile the number of all vertices, and of all faces.
  std::vector<std::uint64_t> first_vertex_, first_face_;
};

}  // namespace winnow
