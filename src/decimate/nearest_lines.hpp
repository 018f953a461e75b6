// Into which neighbour a vertex is removed.
#pragma once

#include "base/vector.hpp"

#include <cstddef>
#include <span>
#include <vector>

namespace winnow {

// The neighbours in the order in which they are tried (Guha, section 4.1): of the lines through two of
// them, the one that passes closest to the vertex first, and of each line the nearer end. Where several lines
// are as close, as on flat parts, the near ends go first.
//
// Only the pair that is closest stands in the paper: the next ones follow where a collapse is refused. A
// neighbour that is the nearer end of several lines is tried once.
std::vector<std::size_t> nearest_line_ends(std::span<const Point> seen);

}  // namespace winnow
