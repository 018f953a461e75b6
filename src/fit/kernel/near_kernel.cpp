// Compiled once for each instruction set, with WINNOW_KERNEL naming it (src/CMakeLists.txt).
#include "fit/kernel/near_kernel.hpp"

#define WINNOW_JOIN2(a, b) a##b
#define WINNOW_JOIN(a, b) WINNOW_JOIN2(a, b)

namespace winnow {

namespace {

inline float smaller(float a, float b) {
  return a < b ? a : b;
}

// 0 for what is no number.
inline float clamped(float x, float most) {
  const float positive = x > 0 ? x : 0;
  return positive < most ? positive : most;
}

void look_at(PointGroup& points, std::size_t count, const FaceBeside& beside, std::int32_t number) {
  const FlatFace& face = beside.face;
  const float ox = beside.corner[0], oy = beside.corner[1], oz = beside.corner[2];
  const float ax = face.along[0], ay = face.along[1], az = face.along[2];
  const float bx = face.across[0], by = face.across[1], bz = face.across[2];
  const float nx = face.up[0], ny = face.up[1], nz = face.up[2];
  const float second = face.second;
  const float cx = face.third[0], cy = face.third[1];
  const float sx = face.side;
  const float by_first = face.by_first_side, by_second = face.by_second_side;
  for (std::size_t i = 0; i < count; ++i) {
    const float dx = points.place[0][i] - ox;
    const float dy = points.place[1][i] - oy;
    const float dz = points.place[2][i] - oz;
    const float x = dx * ax + dy * ay + dz * az;
    const float y = dx * bx + dy * by + dz * bz;
    const float z = dx * nx + dy * ny + dz * nz;
    // To each side.
    const float ux = x - clamped(x, second);
    const float u = ux * ux + y * y;
    const float t = clamped((x * cx + y * cy) * by_first, 1);
    const float vx = x - t * cx;
    const float vy = y - t * cy;
    const float v = vx * vx + vy * vy;
    const float r = x - second;
    const float s = clamped((r * sx + y * cy) * by_second, 1);
    const float wx = r - s * sx;
    const float wy = y - s * cy;
    const float w = wx * wx + wy * wy;
    const float outside = smaller(u, smaller(v, w));
    // Over the face the least of these is positive.
    const float inside = smaller(y, smaller(cy * x - cx * y, sx * y - cy * r));
    const float flat = inside > 0 ? 0 : outside;
    const float squared = flat + z * z;
    const float least = points.least[i];
    const bool nearer = squared < least;
    const float farther = nearer ? least : squared;
    points.next[i] = smaller(farther, points.next[i]);
    points.least[i] = nearer ? squared : least;
    points.nearest[i] = nearer ? number : points.nearest[i];
  }
}

}  // namespace

float WINNOW_JOIN(near_kernel_, WINNOW_KERNEL)(PointGroup& points, std::size_t count,
                                               const FaceBeside* face, std::size_t faces,
                                               std::int32_t first) {
  count = count / PointGroup::lanes * PointGroup::lanes;
  for (std::size_t f = 0; f < faces; ++f)
    look_at(points, count, face[f], first + static_cast<std::int32_t>(f));
  float most[PointGroup::lanes] = {};
  for (std::size_t i = 0; i < count; i += PointGroup::lanes) {
    for (std::size_t k = 0; k < PointGroup::lanes; ++k) {
      const float least = points.least[i + k];
      most[k] = least > most[k] ? least : most[k];
    }
  }
  float largest = 0;
  for (const float least : most) largest = least > largest ? least : largest;
  return largest;
}

}  // namespace winnow
