// Compiled once for each instruction set, with WINNOW_KERNEL naming it (src/CMakeLists.txt).
#include "decimate/kernel/edge_kernel.hpp"

#define WINNOW_JOIN2(a, b) a##b
#define WINNOW_JOIN(a, b) WINNOW_JOIN2(a, b)

namespace winnow {

namespace {

// Pulls the lowest point towards the middle of the edge where the planes leave it free, as a part of their
// weight: by measurement (bench/RESULTS.md).
constexpr double pull = 1e-4;
// Where planes cost nothing, as on flat parts, short edges go first; as in quadric_placement.hpp, which
// defines functions.
constexpr double edge_length_share = 1e-6;

// The lowest point of the planes of both ends, pulled to the middle of the edge: as lowest_point() of
// base/quadric.hpp.
void place(EdgeBatch& batch, std::size_t end) {
  const double lx = batch.low[0], ly = batch.low[1], lz = batch.low[2];
  const VertexPlanes p = batch.low_planes;
  for (std::size_t i = 0; i < end; ++i) {
    const double ex = batch.high[0][i] - lx, ey = batch.high[1][i] - ly, ez = batch.high[2][i] - lz;
    const double qxx = batch.xx[i], qxy = batch.xy[i], qxz = batch.xz[i];
    const double qyy = batch.yy[i], qyz = batch.yz[i], qzz = batch.zz[i];
    const double xx = qxx + p.xx, xy = qxy + p.xy, xz = qxz + p.xz;
    const double yy = qyy + p.yy, yz = qyz + p.yz, zz = qzz + p.zz;
    const double weight = xx + yy + zz;
    const double mx = 0.5 * ex, my = 0.5 * ey, mz = 0.5 * ez;
    const double wxx = xx + pull * weight, wyy = yy + pull * weight, wzz = zz + pull * weight;
    const double rx = (qxx * ex + qxy * ey + qxz * ez) - (xx * mx + xy * my + xz * mz);
    const double ry = (qxy * ex + qyy * ey + qyz * ez) - (xy * mx + yy * my + yz * mz);
    const double rz = (qxz * ex + qyz * ey + qzz * ez) - (xz * mx + yz * my + zz * mz);
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
    for (std::size_t i = 0; i < end; ++i) axis[i] = static_cast<double>(static_cast<float>(axis[i]));
  }
}

void price(EdgeBatch& batch, std::size_t end) {
  const double lx = batch.low[0], ly = batch.low[1], lz = batch.low[2];
  const VertexPlanes p = batch.low_planes;
  for (std::size_t i = 0; i < end; ++i) {
    const double ex = batch.high[0][i] - lx, ey = batch.high[1][i] - ly, ez = batch.high[2][i] - lz;
    const double tx = batch.position[0][i] - lx;
    const double ty = batch.position[1][i] - ly;
    const double tz = batch.position[2][i] - lz;
    const double ux = tx - ex, uy = ty - ey, uz = tz - ez;
    const double qxx = batch.xx[i], qxy = batch.xy[i], qxz = batch.xz[i];
    const double qyy = batch.yy[i], qyz = batch.yz[i], qzz = batch.zz[i];
    // The planes of each end go through it.
    const double low_error = tx * (p.xx * tx + p.xy * ty + p.xz * tz) +
                             ty * (p.xy * tx + p.yy * ty + p.yz * tz) +
                             tz * (p.xz * tx + p.yz * ty + p.zz * tz);
    const double high_error = ux * (qxx * ux + qxy * uy + qxz * uz) + uy * (qxy * ux + qyy * uy + qyz * uz) +
                              uz * (qxz * ux + qyz * uy + qzz * uz);
    const double error = low_error + high_error;
    const double weight = p.xx + p.yy + p.zz + (qxx + qyy + qzz);
    batch.price[i] = (error > 0 ? error : 0) + edge_length_share * weight * (ex * ex + ey * ey + ez * ez);
  }
}

}  // namespace

void WINNOW_JOIN(edge_kernel_, WINNOW_KERNEL)(EdgeBatch& batch, std::size_t count, bool single) {
  const std::size_t end = (count + edge_kernel_lanes - 1) / edge_kernel_lanes * edge_kernel_lanes;
  place(batch, end);
  if (single) round_to_floats(batch, end);
  price(batch, end);
}

}  // namespace winnow
