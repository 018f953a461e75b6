// What edges cost by the planes of the faces at both ends (quadric_cost.hpp), and where each would
// be collapsed to. As cluster/kernel/corner_kernel.hpp:
// compiled once for each instruction set, the same results from all, and no function may be defined
// here.
#pragma once

#include <cstddef>

namespace winnow {

// The sum of weight * n n' over planes through one vertex.
struct VertexPlanes {
  double xx = 0, xy = 0, xz = 0, yy = 0, yz = 0, zz = 0;
};

// Some edges, one array for each number of their ends.
struct EdgeBatch {
  static constexpr std::size_t capacity = 16;

  double low[3][capacity], high[3][capacity];
  double low_planes[6][capacity], high_planes[6][capacity];  // xx, xy, xz, yy, yz, zz
  double to_high[capacity];  // 1 where the edge may only be collapsed into its high end; else 0

  // Results.
  double cost[capacity];
  double position[3][capacity];
  double at_low[capacity], at_high[capacity];      // what is lost at the ends
  double flat_low[capacity], flat_high[capacity];  // 1 where that is nothing but rounding
};

// Of the first `count` edges; results of those behind, up to the next multiple of
// `edge_kernel_lanes`, are without meaning. `single`: positions are numbers that floats have.
using EdgeKernel = void (*)(EdgeBatch& batch, std::size_t count, bool single);
inline constexpr std::size_t edge_kernel_lanes = 4;

void edge_kernel_baseline(EdgeBatch& batch, std::size_t count, bool single);
void edge_kernel_avx2(EdgeBatch& batch, std::size_t count, bool single);
void edge_kernel_avx512(EdgeBatch& batch, std::size_t count, bool single);

}  // namespace winnow
