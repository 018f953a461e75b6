// Filling what the edge kernels take (kernel/edge_kernel.hpp).
#pragma once

#include "base/vector.hpp"
#include "decimate/kernel/edge_kernel.hpp"

#include <algorithm>
#include <cstddef>

namespace winnow {

// A plane that stands upright on `along`, weighted besides by the square of its length.
inline void add(VertexPlanes& planes, const Point& along, double weight) {
  planes.xx += weight * along[0] * along[0];
  planes.xy += weight * along[0] * along[1];
  planes.xz += weight * along[0] * along[2];
  planes.yy += weight * along[1] * along[1];
  planes.yz += weight * along[1] * along[2];
  planes.zz += weight * along[2] * along[2];
}

// The line along an edge, as two planes through it that stand upright on each other: the square of
// the distance from it times that of its length, times `weight`.
inline void add_line(VertexPlanes& planes, const Point& edge, double weight) {
  const double square = dot(edge, edge);
  add(planes, edge, -weight);
  planes.xx += weight * square;
  planes.yy += weight * square;
  planes.zz += weight * square;
}

inline void add(VertexPlanes& planes, const VertexPlanes& more) {
  planes.xx += more.xx;
  planes.xy += more.xy;
  planes.xz += more.xz;
  planes.yy += more.yy;
  planes.yz += more.yz;
  planes.zz += more.zz;
}

inline double weight_of(const VertexPlanes& planes) {
  return planes.xx + planes.yy + planes.zz;
}

inline void set_planes(double (&sums)[6][EdgeBatch::capacity], std::size_t i,
                       const VertexPlanes& planes) {
  sums[0][i] = planes.xx;
  sums[1][i] = planes.xy;
  sums[2][i] = planes.xz;
  sums[3][i] = planes.yy;
  sums[4][i] = planes.yz;
  sums[5][i] = planes.zz;
}

inline void set_low(EdgeBatch& batch, std::size_t i, const Point& low, const VertexPlanes& planes) {
  for (std::size_t axis = 0; axis < 3; ++axis) batch.low[axis][i] = low[axis];
  set_planes(batch.low_planes, i, planes);
}

// Of all edges.
inline void set_low(EdgeBatch& batch, const Point& low, const VertexPlanes& planes) {
  for (std::size_t i = 0; i < EdgeBatch::capacity; ++i) set_low(batch, i, low, planes);
}

// `stays`: this end takes whatever is collapsed into it, where it is.
inline void set_high(EdgeBatch& batch, std::size_t i, const Point& high, const VertexPlanes& planes,
                     bool stays) {
  batch.to_high[i] = stays ? 1.0 : 0.0;
  for (std::size_t axis = 0; axis < 3; ++axis) batch.high[axis][i] = high[axis];
  set_planes(batch.high_planes, i, planes);
}

inline Point position_of(const EdgeBatch& batch, std::size_t i) {
  return {batch.position[0][i], batch.position[1][i], batch.position[2][i]};
}

}  // namespace winnow
