#include "base/quadric.hpp"

namespace winnow {

// (A + pull) t = b + pull * rest by Cramer's rule: the pull keeps the determinant well above zero.
Point lowest_point(const Quadric& q, double pull, const Point& rest) {
  const double xx = q.xx + pull;
  const double yy = q.yy + pull;
  const double zz = q.zz + pull;
  const Point right = q.b - q.times(rest);
  const double cx = yy * zz - q.yz * q.yz;
  const double cy = q.xz * q.yz - q.xy * zz;
  const double cz = q.xy * q.yz - q.xz * yy;
  const double inverse = 1 / (xx * cx + q.xy * cy + q.xz * cz);
  const double dy = xx * zz - q.xz * q.xz;
  const double dz = q.xy * q.xz - xx * q.yz;
  const double ez = xx * yy - q.xy * q.xy;
  const Point step{cx * right[0] + cy * right[1] + cz * right[2],
                   cy * right[0] + dy * right[1] + dz * right[2],
                   cz * right[0] + dz * right[1] + ez * right[2]};
  return rest + inverse * step;
}

}  // namespace winnow
