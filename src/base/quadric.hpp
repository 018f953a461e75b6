// The summed squared distances from planes (Garland and Heckbert 1997), each weighted by the area
// it stands for. Seen from the vertex that has it, so that nothing cancels however far away the
// origin is.
#pragma once

#include "base/vector.hpp"

#include <array>
#include <cstddef>

namespace winnow {

// At t (from its vertex): t'At - 2 b't + c.
struct Quadric {
  double xx = 0, xy = 0, xz = 0, yy = 0, yz = 0, zz = 0;  // A, the sum of weight * n n'
  Point b{};     // the sum of weight * (n . place of the plane) n
  double c = 0;  // the error at the vertex itself: at least 0

  // Of the plane with the unit normal `normal` through `at` (from the vertex).
  void add_plane(const Point& normal, const Point& at, double weight) {
    const Point n = weight * normal;
    const double distance = dot(normal, at);
    xx += n[0] * normal[0];
    xy += n[0] * normal[1];
    xz += n[0] * normal[2];
    yy += n[1] * normal[1];
    yz += n[1] * normal[2];
    zz += n[2] * normal[2];
    b = b + distance * n;
    c += weight * distance * distance;
  }

  // Of the line through the vertex along `edge`, with the square of its length times `weight`.
  void add_line(const Point& edge, double weight) {
    const double square = dot(edge, edge);
    xx += weight * (square - edge[0] * edge[0]);
    xy -= weight * edge[0] * edge[1];
    xz -= weight * edge[0] * edge[2];
    yy += weight * (square - edge[1] * edge[1]);
    yz -= weight * edge[1] * edge[2];
    zz += weight * (square - edge[2] * edge[2]);
  }

  void add(const Quadric& q) {
    xx += q.xx;
    xy += q.xy;
    xz += q.xz;
    yy += q.yy;
    yz += q.yz;
    zz += q.zz;
    b = b + q.b;
    c += q.c;
  }

  [[nodiscard]] Point times(const Point& t) const {
    return {xx * t[0] + xy * t[1] + xz * t[2], xy * t[0] + yy * t[1] + yz * t[2],
            xz * t[0] + yz * t[1] + zz * t[2]};
  }

  [[nodiscard]] double at(const Point& t) const { return dot(t, times(t)) - 2 * dot(b, t) + c; }

  // The same planes seen from the point `t`.
  [[nodiscard]] Quadric from(const Point& t) const {
    Quadric q = *this;
    q.b = b - times(t);
    q.c = at(t);
    return q;
  }

  // The sum of the weights: normals are of unit length.
  [[nodiscard]] double weight() const { return xx + yy + zz; }
};

// The point t that makes q.at(t) + pull * |t - rest|^2 least; pull > 0.
Point lowest_point(const Quadric& q, double pull, const Point& rest);

}  // namespace winnow
