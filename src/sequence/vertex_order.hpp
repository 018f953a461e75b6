// The order in which a sequence keeps its vertices: that of their places in the first frame.
#pragma once

#include "base/morton.hpp"
#include "base/vector.hpp"
#include "io/job.hpp"

#include <cstdint>
#include <vector>

namespace winnow {

struct VertexOrder {
  std::vector<CellKey> key;          // of the vertices in order
  std::vector<std::uint32_t> input;  // their numbers in the input
  std::vector<std::uint32_t> place;  // the other way: of each vertex of the input
};

// By their keys on a lattice over all of them, then by position; those that are not finite are the
// last of the lowest key. `keys` is for the keys of the vertices as they come.
VertexOrder order_by_place(Job& job, const std::vector<Point>& positions,
                           std::vector<CellKey>& keys);

// In place.
void put_in_order(std::vector<Point>& positions, const VertexOrder& order);

}  // namespace winnow
