// The order in which welding names positions.
#pragma once

#include "base/hash.hpp"
#include "base/vector.hpp"
#include "cluster/grid.hpp"

#include <bit>
#include <cmath>
#include <cstdint>
#include <vector>

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

inline std::uint64_t mixed_bits(const Point& p) {
  return std::bit_cast<std::uint64_t>(p[0]) + 3 * std::bit_cast<std::uint64_t>(p[1]) +
         5 * std::bit_cast<std::uint64_t>(p[2]);
}

// Positions that were added lately: on a coherent mesh most corners repeat one of them.
class RecentPositions {
 public:
  RecentPositions() : recent_(std::size_t{1} << bits, Point{NAN, NAN, NAN}) {}

  static constexpr std::uint64_t bytes = (std::uint64_t{1} << 12) * sizeof(Point);

  bool add(const Point& p) {
    Point& recent = recent_[quick_hash(mixed_bits(p)) >> (64 - bits)];
    if (recent == p) return false;
    recent = p;
    return true;
  }

 private:
  static constexpr unsigned bits = 12;

  std::vector<Point> recent_;
};

// Fine enough that few positions share a key, and coarse enough that the lattice has room for a
// shifted copy.
Grid lattice_over(const Box& box);

}  // namespace winnow
