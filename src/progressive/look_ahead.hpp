// The faces at vertices that will be asked for, without waiting for memory: a while before, the
// processor is told of the vertex, then of the first of its corners, then step by step of the next.
#pragma once

#include "progressive/split_mesh.hpp"

#include <array>
#include <cstddef>
#include <cstdint>

namespace winnow {

class LookAhead {
 public:
  LookAhead() { corner_.fill(no_number); }

  // Before the vertex at `place` of `count` is asked for: vertex(place). To be called for one after
  // the other. A corner may be one of another vertex by then.
  template <typename Vertex>
  void go_to(const SplitMesh& mesh, std::size_t place, std::size_t count, const Vertex& vertex) {
    for (std::size_t near = apart; near < begun; near += apart) {
      std::uint32_t& corner = corner_[(place + near) % corner_.size()];
      corner = mesh.next_expected(corner);
    }
    if (place + begun < count)
      corner_[(place + begun) % corner_.size()] = mesh.first_expected(vertex(place + begun));
    if (place + told < count) mesh.expect(vertex(place + told));
  }

 private:
  // Vertices between two steps, and up to the first ones.
  static constexpr std::size_t apart = 2, begun = 10 * apart, told = begun + 4 * apart;

  std::array<std::uint32_t, 32> corner_{};
};

}  // namespace winnow
