// Which vertex of a tile each was collapsed into.
#pragma once

#include "decimate/tile_mesh.hpp"

#include <cstdint>
#include <vector>

namespace winnow {

class CollapsedInto {
 public:
  // Of no vertices: nothing is remembered.
  explicit CollapsedInto(VertexNumber vertices = 0) : into_(vertices, no_number) {}

  static constexpr std::uint64_t memory(std::uint64_t vertices) {
    return vertices * sizeof(VertexNumber);
  }

  // To be told of every collapse.
  void collapsed(const Collapse& edge) {
    if (!into_.empty() && !edge.of_piece()) into_[edge.removed] = edge.kept;
  }

  // The vertex that `v` is a part of by now.
  VertexNumber of(VertexNumber v) {
    while (into_[v] != no_number) {
      const VertexNumber next = into_[v];
      if (into_[next] != no_number) into_[v] = into_[next];
      v = next;
    }
    return v;
  }

 private:
  std::vector<VertexNumber> into_;
};

}  // namespace winnow
