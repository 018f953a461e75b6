// The vertices of a finely cut boundary of blocks, numbered without storing any of them: first the
// corners, then the insides of the edges, then the insides of the squares. The table is as small as
// the coarse boundary.
#pragma once

#include "generate/blocks.hpp"
#include "generate/surface.hpp"

#include <array>
#include <cstdint>
#include <vector>

namespace winnow {

// A corner, or the inside of an edge or of a square: vertices with consecutive numbers, in rows
// along axis b.
struct Patch {
  std::uint64_t begin;              // its first vertex
  std::uint64_t row;                // vertices in a row
  std::array<std::size_t, 2> axis;  // b and c
  std::array<double, 2> step;       // from vertex to vertex along them; 0 where it does not extend
  Point origin;                     // where its first vertex is
};

// A square as its faces see it: 3 x 3 patches, namely its corners, its edges and, in the middle,
// its inside.
struct Sheet {
  std::uint64_t begin;                  // its first face
  std::array<std::uint64_t, 2> pieces;  // along b and c
  bool upwards;
  std::array<std::array<std::uint64_t, 3>, 3> patch_begin;  // by side along c, then along b

  // The number of the vertex at (b, c), from (0, 0) to (pieces[0], pieces[1]).
  [[nodiscard]] std::uint64_t vertex(std::uint64_t b, std::uint64_t c) const {
    const std::size_t side_b = b == 0 ? 0 : b < pieces[0] ? 1 : 2;
    const std::size_t side_c = c == 0 ? 0 : c < pieces[1] ? 1 : 2;
    std::uint64_t number = patch_begin[side_c][side_b];
    if (side_b == 1) number += b - 1;
    if (side_c == 1) number += (c - 1) * (side_b == 1 ? pieces[0] - 1 : 1);
    return number;
  }
};

struct Patches {
  std::vector<Patch> patches;  // by first vertex; some hold none
  std::vector<Sheet> sheets;   // by first face
  std::uint64_t vertices = 0, faces = 0;
};

Patches number_patches(const Blocks& blocks, const Pieces& pieces);

}  // namespace winnow
