// Compiled once for each instruction set, with WINNOW_KERNEL naming it (src/CMakeLists.txt).
#include "decimate/kernel/star_kernel.hpp"

#define WINNOW_JOIN2(a, b) a##b
#define WINNOW_JOIN(a, b) WINNOW_JOIN2(a, b)

namespace winnow {

namespace {

// A face this thin, as the sine of an angle, is a line: its normal is made of rounding.
constexpr double thinnest = 1e-10;

double larger(double a, double b) {
  return a > b ? a : b;
}
double smaller(double a, double b) {
  return a < b ? a : b;
}
double size_of(double a) {
  return a < 0 ? -a : a;
}

std::size_t whole_lanes(std::size_t count) {
  return (count + star_kernel_lanes - 1) / star_kernel_lanes * star_kernel_lanes;
}

template <bool planes>
void turn(StarBatch& batch, std::size_t end, const StarRules& rules) {
  const double tx = batch.to[0], ty = batch.to[1], tz = batch.to[2];
  const double least_cosine = rules.least_cosine, rounding = rules.rounding,
               absolute = rules.absolute;
  for (std::size_t i = 0; i < end; ++i) {
    const double fx = batch.from[0][i], fy = batch.from[1][i], fz = batch.from[2][i];
    const double wx = batch.second[0][i], wy = batch.second[1][i], wz = batch.second[2][i];
    const double xx = batch.third[0][i], xy = batch.third[1][i], xz = batch.third[2][i];
    // Doubled areas along the normals, before ...
    const double ax = wx - fx, ay = wy - fy, az = wz - fz;
    const double bx = xx - fx, by = xy - fy, bz = xz - fz;
    const double mx = ay * bz - az * by, my = az * bx - ax * bz, mz = ax * by - ay * bx;
    // ... and after.
    const double ux = wx - tx, uy = wy - ty, uz = wz - tz;
    const double vx = xx - tx, vy = xy - ty, vz = xz - tz;
    const double nx = uy * vz - uz * vy, ny = uz * vx - ux * vz, nz = ux * vy - uy * vx;
    const double old_square = mx * mx + my * my + mz * mz;
    const double new_square = nx * nx + ny * ny + nz * nz;

    // thinner_than_rounding() of base/rounding.hpp.
    const double sx = larger(size_of(wx), size_of(xx));
    const double sy = larger(size_of(wy), size_of(xy));
    const double sz = larger(size_of(wz), size_of(xz));
    const double ox = rounding * larger(sx, size_of(fx)) + absolute;
    const double oy = rounding * larger(sy, size_of(fy)) + absolute;
    const double oz = rounding * larger(sz, size_of(fz)) + absolute;
    const double abx = size_of(ax) + size_of(bx), aby = size_of(ay) + size_of(by),
                 abz = size_of(az) + size_of(bz);
    const bool thin_before = (size_of(mx) <= aby * oz + abz * oy) &
                             (size_of(my) <= abz * ox + abx * oz) &
                             (size_of(mz) <= abx * oy + aby * ox);
    const double px = rounding * larger(sx, size_of(tx)) + absolute;
    const double py = rounding * larger(sy, size_of(ty)) + absolute;
    const double pz = rounding * larger(sz, size_of(tz)) + absolute;
    const double uvx = size_of(ux) + size_of(vx), uvy = size_of(uy) + size_of(vy),
                 uvz = size_of(uz) + size_of(vz);
    const bool thin = (size_of(nx) <= uvy * pz + uvz * py) & (size_of(ny) <= uvz * px + uvx * pz) &
                      (size_of(nz) <= uvx * py + uvy * px);

    const double ex = xx - wx, ey = xy - wy, ez = xz - wz;
    const double longest = larger(larger(ux * ux + uy * uy + uz * uz, vx * vx + vy * vy + vz * vz),
                                  ex * ex + ey * ey + ez * ez);
    const double cosine = mx * nx + my * ny + mz * nz;
    const bool line = thin | !(new_square > thinnest * thinnest * longest * longest);
    const bool far = !(cosine >= least_cosine * __builtin_sqrt(old_square * new_square));
    const bool stays = batch.stays[i] != 0;
    // What had no direction has none to turn from.
    const bool turned = stays & !thin_before & (line | far);
    const bool opened = stays & thin_before & !line;
    batch.turned[i] = turned ? 1.0 : 0.0;
    batch.opened[i] = opened ? 1.0 : 0.0;

    if constexpr (!planes) continue;
    const double old_inverse = 1 / (6 * __builtin_sqrt(old_square));
    const double new_inverse = 1 / (6 * __builtin_sqrt(new_square));
    const double p = thin_before ? 0.0 : old_inverse;
    const double q = (stays & !thin) != 0 ? new_inverse : 0.0;
    const double pxx = p * mx * mx, pxy = p * mx * my, pxz = p * mx * mz;
    const double pyy = p * my * my, pyz = p * my * mz, pzz = p * mz * mz;
    const double qxx = q * nx * nx, qxy = q * nx * ny, qxz = q * nx * nz;
    const double qyy = q * ny * ny, qyz = q * ny * nz, qzz = q * nz * nz;
    batch.planes[0][i] = qxx;
    batch.planes[1][i] = qxy;
    batch.planes[2][i] = qxz;
    batch.planes[3][i] = qyy;
    batch.planes[4][i] = qyz;
    batch.planes[5][i] = qzz;
    batch.change[0][i] = qxx - pxx;
    batch.change[1][i] = qxy - pxy;
    batch.change[2][i] = qxz - pxz;
    batch.change[3][i] = qyy - pyy;
    batch.change[4][i] = qyz - pyz;
    batch.change[5][i] = qzz - pzz;
  }
}

}  // namespace

void WINNOW_JOIN(star_kernel_, WINNOW_KERNEL)(StarBatch& batch, std::size_t count,
                                              const StarRules& rules) {
  if (rules.planes) {
    turn<true>(batch, whole_lanes(count), rules);
  } else {
    turn<false>(batch, whole_lanes(count), rules);
  }
}

void WINNOW_JOIN(plane_kernel_, WINNOW_KERNEL)(StarBatch& batch, std::size_t count,
                                               const StarRules& rules) {
  const std::size_t end = whole_lanes(count);
  const double rounding = rules.rounding, absolute = rules.absolute;
  for (std::size_t i = 0; i < end; ++i) {
    const double fx = batch.from[0][i], fy = batch.from[1][i], fz = batch.from[2][i];
    const double wx = batch.second[0][i], wy = batch.second[1][i], wz = batch.second[2][i];
    const double xx = batch.third[0][i], xy = batch.third[1][i], xz = batch.third[2][i];
    const double ax = wx - fx, ay = wy - fy, az = wz - fz;
    const double bx = xx - fx, by = xy - fy, bz = xz - fz;
    const double mx = ay * bz - az * by, my = az * bx - ax * bz, mz = ax * by - ay * bx;
    // thinner_than_rounding() of base/rounding.hpp.
    const double ox = rounding * larger(larger(size_of(wx), size_of(xx)), size_of(fx)) + absolute;
    const double oy = rounding * larger(larger(size_of(wy), size_of(xy)), size_of(fy)) + absolute;
    const double oz = rounding * larger(larger(size_of(wz), size_of(xz)), size_of(fz)) + absolute;
    const double abx = size_of(ax) + size_of(bx), aby = size_of(ay) + size_of(by),
                 abz = size_of(az) + size_of(bz);
    const bool thin = (size_of(mx) <= aby * oz + abz * oy) & (size_of(my) <= abz * ox + abx * oz) &
                      (size_of(mz) <= abx * oy + aby * ox);
    const double inverse = 1 / (6 * __builtin_sqrt(mx * mx + my * my + mz * mz));
    const double p = thin ? 0.0 : inverse;
    batch.planes[0][i] = p * mx * mx;
    batch.planes[1][i] = p * mx * my;
    batch.planes[2][i] = p * mx * mz;
    batch.planes[3][i] = p * my * my;
    batch.planes[4][i] = p * my * mz;
    batch.planes[5][i] = p * mz * mz;
  }
}

void WINNOW_JOIN(distance_kernel_, WINNOW_KERNEL)(const StarBatch& batch, std::size_t count,
                                                  const double (&points)[2][3],
                                                  double (&least)[2][star_kernel_lanes]) {
  const std::size_t end = whole_lanes(count);
  const double tx = batch.to[0], ty = batch.to[1], tz = batch.to[2];
  const double px = points[0][0] - tx, py = points[0][1] - ty, pz = points[0][2] - tz;
  const double qx = points[1][0] - tx, qy = points[1][1] - ty, qz = points[1][2] - tz;
  double of_first[StarBatch::capacity], of_second[StarBatch::capacity];
  for (std::size_t i = 0; i < end; ++i) {
    const double ux = batch.second[0][i] - tx, uy = batch.second[1][i] - ty,
                 uz = batch.second[2][i] - tz;
    const double vx = batch.third[0][i] - tx, vy = batch.third[1][i] - ty,
                 vz = batch.third[2][i] - tz;
    const double nx = uy * vz - uz * vy, ny = uz * vx - ux * vz, nz = ux * vy - uy * vx;
    const double square = nx * nx + ny * ny + nz * nz;
    const bool stays = (i < count) & (batch.stays[i] != 0) & (square > 0);
    // A point is a * u + b * v beside its height; both times the square of the normal.
    const double pa =
        (py * vz - pz * vy) * nx + (pz * vx - px * vz) * ny + (px * vy - py * vx) * nz;
    const double pb =
        (uy * pz - uz * py) * nx + (uz * px - ux * pz) * ny + (ux * py - uy * px) * nz;
    const double qa =
        (qy * vz - qz * vy) * nx + (qz * vx - qx * vz) * ny + (qx * vy - qy * vx) * nz;
    const double qb =
        (uy * qz - uz * qy) * nx + (uz * qx - ux * qz) * ny + (ux * qy - uy * qx) * nz;
    const double p_height = px * nx + py * ny + pz * nz;
    const double q_height = qx * nx + qy * ny + qz * nz;
    const bool above_p = stays & (pa >= 0) & (pb >= 0) & (pa + pb <= square);
    const bool above_q = stays & (qa >= 0) & (qb >= 0) & (qa + qb <= square);
    of_first[i] = above_p ? p_height * p_height / square : __builtin_inf();
    of_second[i] = above_q ? q_height * q_height / square : __builtin_inf();
  }
  for (std::size_t first = 0; first < end; first += star_kernel_lanes) {
    for (std::size_t lane = 0; lane < star_kernel_lanes; ++lane) {
      least[0][lane] = smaller(of_first[first + lane], least[0][lane]);
      least[1][lane] = smaller(of_second[first + lane], least[1][lane]);
    }
  }
}

}  // namespace winnow
