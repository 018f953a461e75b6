// Compiled once for each instruction set, with WINNOW_KERNEL naming it (src/CMakeLists.txt). Plain loops over
// arrays, one step each, that the compiler turns into vector code. No branches: every choice is a select.
#include "cluster/kernel/corner_kernel.hpp"

#include <math.h>

#define WINNOW_JOIN2(a, b) a##b
#define WINNOW_JOIN(a, b) WINNOW_JOIN2(a, b)

namespace winnow {

namespace {

constexpr double cells_an_axis = 2097152.0;
constexpr double fraction_scale = 1 << fraction_bits;
constexpr float normal_scale = 1 << fraction_bits;
constexpr float area_scale = 1 << area_bits;
constexpr float weight_limit = 1 << weight_limit_bits;

// Edges and derived numbers between the loops, in cell units.
struct Scratch {
  alignas(64) float ab[3][kernel_capacity];
  alignas(64) float ac[3][kernel_capacity];
  alignas(64) float bc[3][kernel_capacity];
  alignas(64) float normal[3][kernel_capacity];
  alignas(64) std::int32_t cell[3][3][kernel_capacity];
  alignas(64) std::int32_t wrong[kernel_capacity];
  alignas(64) std::int32_t repeated[kernel_capacity];
};

inline std::int32_t rounded(float value) {
  return static_cast<std::int32_t>(value + (value < 0 ? -0.5F : 0.5F));
}

void find_bad(const KernelInput& in, std::size_t n, Scratch& s) {
  for (std::size_t i = 0; i < n; ++i) s.wrong[i] = 0;
  for (std::size_t corner = 0; corner < 3; ++corner) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const double* p = in.position[corner][axis];
      const double origin = in.origin[axis];
      const double inverse = in.inverse;
      for (std::size_t i = 0; i < n; ++i) {
        const double place = (p[i] - origin) * inverse;
        // Not a number fails both comparisons.
        s.wrong[i] |= (place >= 0 ? 0 : 1) | (place < cells_an_axis ? 0 : 1);
      }
    }
  }
  const auto& p = in.position;
  for (std::size_t i = 0; i < n; ++i) {
    const int ab = (p[0][0][i] == p[1][0][i]) & (p[0][1][i] == p[1][1][i]) & (p[0][2][i] == p[1][2][i]);
    const int ac = (p[0][0][i] == p[2][0][i]) & (p[0][1][i] == p[2][1][i]) & (p[0][2][i] == p[2][2][i]);
    const int bc = (p[1][0][i] == p[2][0][i]) & (p[1][1][i] == p[2][1][i]) & (p[1][2][i] == p[2][2][i]);
    s.repeated[i] = ab | ac | bc;
  }
}

void place_corners(const KernelInput& in, std::size_t n, Scratch& s, CornerSums& out) {
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const double* a = in.position[0][axis];
    const double* b = in.position[1][axis];
    const double* c = in.position[2][axis];
    const double origin = in.origin[axis];
    const double inverse = in.inverse;
    for (std::size_t i = 0; i < n; ++i) {
      const bool good = s.wrong[i] == 0;
      const double ua = good ? (a[i] - origin) * inverse : 0;
      const double ub = good ? (b[i] - origin) * inverse : 0;
      const double uc = good ? (c[i] - origin) * inverse : 0;
      const auto ca = static_cast<std::int32_t>(ua);
      const auto cb = static_cast<std::int32_t>(ub);
      const auto cc = static_cast<std::int32_t>(uc);
      s.cell[0][axis][i] = ca;
      s.cell[1][axis][i] = cb;
      s.cell[2][axis][i] = cc;
      out.fraction[0][axis][i] = static_cast<std::int32_t>((ua - ca) * fraction_scale + 0.5);
      out.fraction[1][axis][i] = static_cast<std::int32_t>((ub - cb) * fraction_scale + 0.5);
      out.fraction[2][axis][i] = static_cast<std::int32_t>((uc - cc) * fraction_scale + 0.5);
      s.ab[axis][i] = static_cast<float>(ub - ua);
      s.ac[axis][i] = static_cast<float>(uc - ua);
      s.bc[axis][i] = static_cast<float>(uc - ub);
    }
  }
  for (std::size_t corner = 0; corner < 3; ++corner) {
    for (std::size_t i = 0; i < n; ++i) {
      out.cell[corner][i] = static_cast<std::uint64_t>(static_cast<std::uint32_t>(s.cell[corner][0][i])) |
                            static_cast<std::uint64_t>(static_cast<std::uint32_t>(s.cell[corner][1][i])) << 21 |
                            static_cast<std::uint64_t>(static_cast<std::uint32_t>(s.cell[corner][2][i])) << 42;
    }
  }
}

// Rounded up, so that no corner vanishes, and limited, so that no face overflows a sum by itself.
inline std::int32_t weight_of(float area, std::int32_t& clamped) {
  const float units = area * area_scale;
  clamped |= units >= weight_limit ? 1 : 0;
  const float limited = units < weight_limit ? units : weight_limit;
  const auto whole = static_cast<std::int32_t>(limited);
  const std::int32_t up = whole + (static_cast<float>(whole) < limited ? 1 : 0);
  return up < 1 ? 1 : up;
}

void weigh_corners(std::size_t n, Scratch& s, CornerSums& out) {
  std::int32_t clamped = 0;
  for (std::size_t i = 0; i < n; ++i) {
    const float abx = s.ab[0][i], aby = s.ab[1][i], abz = s.ab[2][i];
    const float acx = s.ac[0][i], acy = s.ac[1][i], acz = s.ac[2][i];
    const float bcx = s.bc[0][i], bcy = s.bc[1][i], bcz = s.bc[2][i];
    const float nx = aby * acz - abz * acy;
    const float ny = abz * acx - abx * acz;
    const float nz = abx * acy - aby * acx;
    const float doubled_area = sqrtf(nx * nx + ny * ny + nz * nz);
    const float reciprocal = doubled_area > 0 ? 1 / doubled_area : 0.0F;
    const float dot_a = abx * acx + aby * acy + abz * acz;
    const float dot_b = -(abx * bcx + aby * bcy + abz * bcz);
    const float dot_c = acx * bcx + acy * bcy + acz * bcz;
    const float ab = abx * abx + aby * aby + abz * abz;
    const float ac = acx * acx + acy * acy + acz * acz;
    const float bc = bcx * bcx + bcy * bcy + bcz * bcz;
    // cot X = dot_x / doubled_area.
    const float eighth = reciprocal * 0.125F;
    const float plain_a = (ab * dot_c + ac * dot_b) * eighth;
    const float plain_b = (ab * dot_c + bc * dot_a) * eighth;
    const float plain_c = (ac * dot_b + bc * dot_a) * eighth;
    const bool obtuse = (dot_a < 0) | (dot_b < 0) | (dot_c < 0);
    const float half = doubled_area * 0.25F;      // half the area
    const float quarter = doubled_area * 0.125F;  // a quarter of it
    const float a = obtuse ? (dot_a < 0 ? half : quarter) : plain_a;
    const float b = obtuse ? (dot_b < 0 ? half : quarter) : plain_b;
    const float c = obtuse ? (dot_c < 0 ? half : quarter) : plain_c;
    out.weight[0][i] = weight_of(a, clamped);
    out.weight[1][i] = weight_of(b, clamped);
    out.weight[2][i] = weight_of(c, clamped);
    s.normal[0][i] = nx * reciprocal;
    s.normal[1][i] = ny * reciprocal;
    s.normal[2][i] = nz * reciprocal;
    out.normal[0][i] = rounded(s.normal[0][i] * normal_scale);
    out.normal[1][i] = rounded(s.normal[1][i] * normal_scale);
    out.normal[2][i] = rounded(s.normal[2][i] * normal_scale);
  }
  out.clamped = clamped != 0;
}

void add_up(std::size_t n, CornerSums& out) {
  for (std::size_t i = 0; i < n; ++i) {
    out.total_weight[i] = static_cast<std::int64_t>(out.weight[0][i]) + out.weight[1][i] + out.weight[2][i];
  }
  for (std::size_t axis = 0; axis < 3; ++axis) {
    for (std::size_t i = 0; i < n; ++i) {
      out.total_position[axis][i] = static_cast<std::int64_t>(out.weight[0][i]) * out.fraction[0][axis][i] +
                                    static_cast<std::int64_t>(out.weight[1][i]) * out.fraction[1][axis][i] +
                                    static_cast<std::int64_t>(out.weight[2][i]) * out.fraction[2][axis][i];
    }
    // Not the sum of the weights times the normal: that product of 33 and 23 bits would vectorise badly.
    for (std::size_t i = 0; i < n; ++i) {
      out.total_normal[axis][i] = static_cast<std::int64_t>(out.weight[0][i]) * out.normal[axis][i] +
                                  static_cast<std::int64_t>(out.weight[1][i]) * out.normal[axis][i] +
                                  static_cast<std::int64_t>(out.weight[2][i]) * out.normal[axis][i];
    }
  }
}

void sort_out(std::size_t n, const Scratch& s, CornerSums& out) {
  for (std::size_t i = 0; i < n; ++i) {
    const bool same = (out.cell[0][i] == out.cell[1][i]) & (out.cell[0][i] == out.cell[2][i]);
    const std::int32_t kind = s.wrong[i] != 0 ? outside : s.repeated[i] != 0 ? repeated_corner : same ? one_cell : several_cells;
    out.kind[i] = static_cast<std::uint8_t>(kind);
  }
}

// The plane seen from the middle of a corner's cell: there |distance| is below 0.87 cells, so every number
// fits beside the normal's.
void find_planes(std::size_t n, const Scratch& s, CornerSums& out) {
  constexpr float to_place = 1.0F / (1 << fraction_bits);
  for (std::size_t i = 0; i < n; ++i) {
    const float x = s.normal[0][i], y = s.normal[1][i], z = s.normal[2][i];
    out.squares[0][i] = rounded(x * x * normal_scale);
    out.squares[1][i] = rounded(x * y * normal_scale);
    out.squares[2][i] = rounded(x * z * normal_scale);
    out.squares[3][i] = rounded(y * y * normal_scale);
    out.squares[4][i] = rounded(y * z * normal_scale);
  }
  for (std::size_t corner = 0; corner < 3; ++corner) {
    for (std::size_t i = 0; i < n; ++i) {
      const float x = s.normal[0][i], y = s.normal[1][i], z = s.normal[2][i];
      const float distance = x * (static_cast<float>(out.fraction[corner][0][i]) * to_place - 0.5F) +
                             y * (static_cast<float>(out.fraction[corner][1][i]) * to_place - 0.5F) +
                             z * (static_cast<float>(out.fraction[corner][2][i]) * to_place - 0.5F);
      out.moment[corner][0][i] = rounded(distance * x * normal_scale);
      out.moment[corner][1][i] = rounded(distance * y * normal_scale);
      out.moment[corner][2][i] = rounded(distance * z * normal_scale);
    }
  }
}

}  // namespace

void WINNOW_JOIN(corner_kernel_, WINNOW_KERNEL)(const KernelInput& input, CornerSums& out) {
  // Whole vectors: the faces beyond the last are computed too, and not looked at.
  const std::size_t n = (input.count + 15) / 16 * 16;
  Scratch scratch;
  find_bad(input, n, scratch);
  place_corners(input, n, scratch, out);
  weigh_corners(n, scratch, out);
  add_up(n, out);
  sort_out(n, scratch, out);
  if (input.quadrics) find_planes(n, scratch, out);
}

}  // namespace winnow
