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

inline void set_low(EdgeBatch& batch, const Point& low, const VertexPlanes& planes) {
  std::copy(low.begin(), low.end(), batch.low);
  batch.low_planes = planes;
}

// `stays`: this end takes whatever is collapsed into it, where it is.
inline void set_high(EdgeBatch& batch, std::size_t i, const Point& high, const VertexPlanes& planes,
                     bool stays) {
  batch.to_high[i] = stays ? 1.0 : 0.0;
  for (std::size_t axis = 0; axis < 3; ++axis) batch.high[axis][i] = high[axis];
  batch.xx[i] = planes.xx;
  batch.xy[i] = planes.xy;
  batch.xz[i] = planes.xz;
  batch.yy[i] = planes.yy;
  batch.yz[i] = planes.yz;
  batch.zz[i] = planes.zz;
}

inline Point position_of(const EdgeBatch& batch, std::size_t i) {
  return {batch.position[0][i], batch.position[1][i], batch.position[2][i]};
}

}  // namespace winnow
