// The order in which welding names positions.
#pragma once

#include "base/vector.hpp"
#include "cluster/grid.hpp"

namespace winnow {

// Turns -0 into 0, which is the same place.
inline Point without_minus_zero(const Point& p) {
  return {p[0] + 0.0, p[1] + 0.0, p[2] + 0.0};
}

// The key of a position's cell. Positions beside the lattice count as if at its sides.
CellKey key_of(const Grid& grid, const Point& p);

struct KeyedPosition {
  CellKey key;
  Point position;

  static bool before(const KeyedPosition& a, const KeyedPosition& b) {
    return a.key != b.key ? a.key < b.key : a.position < b.position;
  }
  static bool combine(KeyedPosition& into, const KeyedPosition& from) {
    return into.position == from.position;
  }
};

// Fine enough that few positions share a key, and coarse enough that the lattice has room for a
// shifted copy.
Grid lattice_over(const Box& box);

}  // namespace winnow
