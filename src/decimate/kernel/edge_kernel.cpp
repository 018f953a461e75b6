// Compiled once for each instruction set, with WINNOW_KERNEL naming it (src/CMakeLists.txt).
#include "decimate/kernel/edge_kernel.hpp"

#define WINNOW_JOIN2(a, b) a##b
#define WINNOW_JOIN(a, b) WINNOW_JOIN2(a, b)

namespace winnow {

namespace {

// Pulls the lowest point towards the middle of the edge where the planes leave it free, as a part
// of their weight: by measurement (bench/RESULTS.md).
constexpr double pull = 1e-4;
// Short edges go first where planes cost next to nothing: the square of the length counts, by this
// part of the planes' weight. As in quadric_placement.hpp, which defines functions.
constexpr double edge_length_share = 1e-6;
// What is flat costs less than all that has a shape, at any scale: only its own order is left
// (2^-700).
constexpr double flat_share = 0x1p-700;
// Of the square of the length beside the planes' weight, for flat edges: orders those without a
// plane.
constexpr double length_beside_weight = 0x1p-20;
// How far planes may be off by the rounding of the positions that they were made from: so many
// times that of a coordinate, since a plane is held by a triangle smaller than the edge is long.
constexpr double rounding_of_floats = 8 * 0x1p-24;
constexpr double rounding_of_doubles = 8 * 0x1p-53;
// The square of what the arithmetic of planes cannot see, beside that of the edge's length.
constexpr double rounding_of_planes = 0x1p-46;

double larger_size(double a, double b) {
  const double x = a < 0 ? -a : a;
  const double y = b < 0 ? -b : b;
  return x > y ? x : y;
}

// The lowest point of the planes of both ends, pulled to the middle of the edge: as lowest_point()
// of base/quadric.hpp. And whether nothing is lost at an end.
void place(EdgeBatch& batch, std::size_t end, double rounding) {
  for (std::size_t i = 0; i < end; ++i) {
    const double lx = batch.low[0][i], ly = batch.low[1][i], lz = batch.low[2][i];
    const double hx = batch.high[0][i], hy = batch.high[1][i], hz = batch.high[2][i];
    const double ex = hx - lx, ey = hy - ly, ez = hz - lz;
    const auto& p = batch.low_planes;
    const auto& q = batch.high_planes;
    const double pxx = p[0][i], pxy = p[1][i], pxz = p[2][i];
    const double pyy = p[3][i], pyz = p[4][i], pzz = p[5][i];
    const double qxx = q[0][i], qxy = q[1][i], qxz = q[2][i];
    const double qyy = q[3][i], qyz = q[4][i], qzz = q[5][i];
    const double xx = qxx + pxx, xy = qxy + pxy, xz = qxz + pxz;
    const double yy = qyy + pyy, yz = qyz + pyz, zz = qzz + pzz;
    const double weight = xx + yy + zz;
    // The planes of each end go through it, so only those of the other lose anything there.
    const double qx = qxx * ex + qxy * ey + qxz * ez;
    const double qy = qxy * ex + qyy * ey + qyz * ez;
    const double qz = qxz * ex + qyz * ey + qzz * ez;
    const double sx = xx * ex + xy * ey + xz * ez;
    const double sy = xy * ex + yy * ey + yz * ez;
    const double sz = xz * ex + yz * ey + zz * ez;
    const double at_low = ex * qx + ey * qy + ez * qz;
    const double at_high = ex * (sx - qx) + ey * (sy - qy) + ez * (sz - qz);
    const double ox = rounding * larger_size(lx, hx);
    const double oy = rounding * larger_size(ly, hy);
    const double oz = rounding * larger_size(lz, hz);
    const double limit = ox * ox * xx + oy * oy * yy + oz * oz * zz +
                         rounding_of_planes * weight * (ex * ex + ey * ey + ez * ez);
    batch.at_low[i] = at_low;
    batch.at_high[i] = at_high;
    batch.flat_low[i] = at_low <= limit ? 1.0 : 0.0;
    batch.flat_high[i] = at_high <= limit ? 1.0 : 0.0;

    const double mx = 0.5 * ex, my = 0.5 * ey, mz = 0.5 * ez;
    const double wxx = xx + pull * weight, wyy = yy + pull * weight, wzz = zz + pull * weight;
    const double rx = qx - 0.5 * sx;
    const double ry = qy - 0.5 * sy;
    const double rz = qz - 0.5 * sz;
    const double cx = wyy * wzz - yz * yz;
    const double cy = xz * yz - xy * wzz;
    const double cz = xy * yz - xz * wyy;
    const double dy = wxx * wzz - xz * xz;
    const double dz = xy * xz - wxx * yz;
    const double fz = wxx * wyy - xy * xy;
    const double inverse = 1 / (wxx * cx + xy * cy + xz * cz);
    const double x = lx + (mx + inverse * (cx * rx + cy * ry + cz * rz));
    const double y = ly + (my + inverse * (cy * rx + dy * ry + dz * rz));
    const double z = lz + (mz + inverse * (cz * rx + dz * ry + fz * rz));
    // Planes without weight, and lengths beyond all numbers, give none.
    const bool there = x * 0 + y * 0 + z * 0 == 0;
    batch.position[0][i] = there ? x : lx;
    batch.position[1][i] = there ? y : ly;
    batch.position[2][i] = there ? z : lz;
  }
}

// A loop of its own: floats beside doubles would ask for twice the lanes.
void round_to_floats(EdgeBatch& batch, std::size_t end) {
  for (double(&axis)[EdgeBatch::capacity] : batch.position) {
    for (std::size_t i = 0; i < end; ++i)
      axis[i] = static_cast<double>(static_cast<float>(axis[i]));
  }
}

// An end where nothing is lost takes the collapse, to the bit.
void cost(EdgeBatch& batch, std::size_t end) {
  for (std::size_t i = 0; i < end; ++i) {
    const double lx = batch.low[0][i], ly = batch.low[1][i], lz = batch.low[2][i];
    const double hx = batch.high[0][i], hy = batch.high[1][i], hz = batch.high[2][i];
    const double at_low = batch.at_low[i], at_high = batch.at_high[i];
    const bool forced = batch.to_high[i] != 0;
    const bool low_flat = (batch.flat_low[i] != 0) & !forced;
    const bool high_flat = batch.flat_high[i] != 0;
    const bool to_high = forced | (high_flat & (!low_flat | (at_high < at_low)));
    const bool to_low = low_flat & !to_high;
    const double x = to_high ? hx : to_low ? lx : batch.position[0][i];
    const double y = to_high ? hy : to_low ? ly : batch.position[1][i];
    const double z = to_high ? hz : to_low ? lz : batch.position[2][i];
    batch.position[0][i] = x;
    batch.position[1][i] = y;
    batch.position[2][i] = z;
    batch.flat_low[i] = low_flat ? 1.0 : 0.0;
    const double ex = hx - lx, ey = hy - ly, ez = hz - lz;
    const double tx = x - lx;
    const double ty = y - ly;
    const double tz = z - lz;
    const double ux = tx - ex, uy = ty - ey, uz = tz - ez;
    const auto& p = batch.low_planes;
    const auto& q = batch.high_planes;
    const double pxx = p[0][i], pxy = p[1][i], pxz = p[2][i];
    const double pyy = p[3][i], pyz = p[4][i], pzz = p[5][i];
    const double qxx = q[0][i], qxy = q[1][i], qxz = q[2][i];
    const double qyy = q[3][i], qyz = q[4][i], qzz = q[5][i];
    // The planes of each end go through it.
    const double low_error = tx * (pxx * tx + pxy * ty + pxz * tz) +
                             ty * (pxy * tx + pyy * ty + pyz * tz) +
                             tz * (pxz * tx + pyz * ty + pzz * tz);
    const double high_error = ux * (qxx * ux + qxy * uy + qxz * uz) +
                              uy * (qxy * ux + qyy * uy + qyz * uz) +
                              uz * (qxz * ux + qyz * uy + qzz * uz);
    const double error = low_error + high_error;
    const double weight = pxx + pyy + pzz + (qxx + qyy + qzz);
    const double square = ex * ex + ey * ey + ez * ez;
    const double lost = error > 0 ? error : 0;
    const double length = edge_length_share * weight * square;
    const double shaped = lost + (length < lost ? length : lost);
    const bool flat = low_flat | high_flat;
    batch.cost[i] = flat ? flat_share * (weight + length_beside_weight * square) * square : shaped;
  }
}

}  // namespace

void WINNOW_JOIN(edge_kernel_, WINNOW_KERNEL)(EdgeBatch& batch, std::size_t count, bool single) {
  if (count == 1) {
    // One by itself needs no lanes.
    place(batch, 1, single ? rounding_of_floats : rounding_of_doubles);
    if (single) round_to_floats(batch, 1);
    cost(batch, 1);
    return;
  }
  const std::size_t end = (count + edge_kernel_lanes - 1) / edge_kernel_lanes * edge_kernel_lanes;
  place(batch, end, single ? rounding_of_floats : rounding_of_doubles);
  if (single) round_to_floats(batch, end);
  cost(batch, end);
}

}  // namespace winnow
