// A solid on a coarse, uneven grid: which blocks of it are filled, and the squares, edges and
// corners of the boundary between filled and empty.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

namespace winnow {

using Place = std::array<std::uint32_t, 3>;  // of a block, or of a corner of the grid

class Blocks {
 public:
  // The coordinates of the grid's planes, ascending, for each axis.
  explicit Blocks(std::array<std::vector<double>, 3> planes);

  // Fills (empties) the blocks from plane `low` to plane `high` on each axis.
  void set(const Place& low, const Place& high, bool filled);

  [[nodiscard]] const std::vector<double>& planes(std::size_t axis) const { return planes_[axis]; }
  [[nodiscard]] std::uint32_t gaps(std::size_t axis) const {
    return static_cast<std::uint32_t>(planes_[axis].size() - 1);
  }

  // A square across `axis`; `place` is its lowest corner. It extends over the gaps place[b] and
  // place[c] of the next two axes b and c, in cyclic order.
  struct Square {
    std::uint8_t axis;
    bool upwards;  // whether outside is where the axis points to
    Place place;
  };
  [[nodiscard]] std::vector<Square> boundary() const;  // in the order of axis, z, y, x

 private:
  [[nodiscard]] std::size_t index(const Place& place) const {
    return (std::size_t{place[2]} * gaps(1) + place[1]) * gaps(0) + place[0];
  }

  std::array<std::vector<double>, 3> planes_;
  std::vector<bool> filled_;
};

// Into how many pieces each gap of each axis is cut.
using Pieces = std::array<std::vector<std::uint64_t>, 3>;

// Pieces of about equal length such that the squares have nearly `wanted` pieces in all; never less
// than one piece a square.
Pieces choose_pieces(const Blocks& blocks, std::uint64_t wanted);

std::uint64_t count_pieces(const std::vector<Blocks::Square>& squares, const Pieces& pieces);

}  // namespace winnow
