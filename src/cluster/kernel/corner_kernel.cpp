// Compiled once for each instruction set, with WINNOW_KERNEL naming it (src/CMakeLists.txt). Plain
// loops over arrays that the compiler turns into vector code: no branches, every choice is a
// select; and no conversion between doubles and 64-bit integers, which only the widest instruction
// set has: adding 1.5 * 2^52 to a number below 2^51 leaves it, rounded, in the low bits of the
// double.
#include "cluster/kernel/corner_kernel.hpp"

#include <math.h>

// No iteration of the next loop reads what another one writes. (Clang finds that out by itself.)
#ifdef __clang__
#define WINNOW_INDEPENDENT
#else
#define WINNOW_INDEPENDENT _Pragma("GCC ivdep")
#endif

#define WINNOW_JOIN2(a, b) a##b
#define WINNOW_JOIN(a, b) WINNOW_JOIN2(a, b)

namespace winnow {

namespace {

constexpr double rounder = 6755399441055744.0;  // 1.5 * 2^52
constexpr std::int64_t rounder_bits = 0x4338000000000000;
constexpr double whole = 4503599627370496.0;  // 2^52
constexpr std::int64_t whole_bits = 0x4330000000000000;

constexpr std::int64_t fraction_mask = (std::int64_t{1} << fraction_bits) - 1;
constexpr double fraction_scale = 1 << fraction_bits;
constexpr float normal_scale = 1 << normal_bits;
constexpr float area_scale = 1 << area_bits;
constexpr float weight_limit = 1 << weight_limit_bits;
constexpr float far_square = 7 * 7;

// Faces done at a time, so that what stands between the loops stays in the first-level cache.
constexpr std::size_t block = 128;

struct Scratch {
  alignas(64) float ab[3][block];
  alignas(64) float ac[3][block];
  alignas(64) float bc[3][block];  // not their difference: of a needle that would leave nothing but
                                   // rounding
  alignas(64) float normal[3][block];
};

inline std::int64_t bits_of(double value) {
  return __builtin_bit_cast(std::int64_t, value);
}
inline double double_of(std::int64_t bits) {
  return __builtin_bit_cast(double, bits);
}

// The whole number nearest to a value below 2^51 in size. Of what is larger, some number: the faces
// that have it are found to be far, and it is not looked at.
inline std::int64_t nearest_whole(double value) {
  return static_cast<std::int64_t>(static_cast<std::uint64_t>(bits_of(value + rounder)) -
                                   static_cast<std::uint64_t>(rounder_bits));
}

// The same for a value from 0 to 2^52.
inline std::int64_t nearest_whole_from_zero(double value) {
  return static_cast<std::int64_t>(static_cast<std::uint64_t>(bits_of(value + whole)) -
                                   static_cast<std::uint64_t>(whole_bits));
}

// Of what is no number, some number: a face without area has it, and it is not looked at.
__attribute__((no_sanitize("float-cast-overflow"))) inline std::int32_t rounded(float value) {
  return static_cast<std::int32_t>(value + (value < 0 ? -0.5F : 0.5F));
}

template <typename Real>
void place_corners(const Real* const (&position)[3][3], const KernelInput& in, std::size_t from,
                   std::size_t n, Scratch& s, CornerSums& out) {
  const double scale = in.inverse * fraction_scale;
  const double ox = in.origin[0], oy = in.origin[1], oz = in.origin[2];
  const Real* pax = position[0][0] + from;
  const Real* pay = position[0][1] + from;
  const Real* paz = position[0][2] + from;
  const Real* pbx = position[1][0] + from;
  const Real* pby = position[1][1] + from;
  const Real* pbz = position[1][2] + from;
  const Real* pcx = position[2][0] + from;
  const Real* pcy = position[2][1] + from;
  const Real* pcz = position[2][2] + from;
  constexpr float to_cells = 1.0F / (1 << fraction_bits);
  WINNOW_INDEPENDENT
  for (std::size_t i = 0; i < n; ++i) {
    const double ax = (pax[i] - ox) * scale + rounder;
    const double ay = (pay[i] - oy) * scale + rounder;
    const double az = (paz[i] - oz) * scale + rounder;
    const double bx = (pbx[i] - ox) * scale + rounder;
    const double by = (pby[i] - oy) * scale + rounder;
    const double bz = (pbz[i] - oz) * scale + rounder;
    const double cx = (pcx[i] - ox) * scale + rounder;
    const double cy = (pcy[i] - oy) * scale + rounder;
    const double cz = (pcz[i] - oz) * scale + rounder;
    s.ab[0][i] = static_cast<float>(bx - ax) * to_cells;
    s.ab[1][i] = static_cast<float>(by - ay) * to_cells;
    s.ab[2][i] = static_cast<float>(bz - az) * to_cells;
    s.ac[0][i] = static_cast<float>(cx - ax) * to_cells;
    s.ac[1][i] = static_cast<float>(cy - ay) * to_cells;
    s.ac[2][i] = static_cast<float>(cz - az) * to_cells;
    s.bc[0][i] = static_cast<float>(cx - bx) * to_cells;
    s.bc[1][i] = static_cast<float>(cy - by) * to_cells;
    s.bc[2][i] = static_cast<float>(cz - bz) * to_cells;
    out.place[0][0][from + i] = bits_of(ax) ^ rounder_bits;
    out.place[0][1][from + i] = bits_of(ay) ^ rounder_bits;
    out.place[0][2][from + i] = bits_of(az) ^ rounder_bits;
    out.place[1][0][from + i] = bits_of(bx) ^ rounder_bits;
    out.place[1][1][from + i] = bits_of(by) ^ rounder_bits;
    out.place[1][2][from + i] = bits_of(bz) ^ rounder_bits;
    out.place[2][0][from + i] = bits_of(cx) ^ rounder_bits;
    out.place[2][1][from + i] = bits_of(cy) ^ rounder_bits;
    out.place[2][2][from + i] = bits_of(cz) ^ rounder_bits;
  }
}

inline std::int64_t packed(std::int64_t x, std::int64_t y, std::int64_t z) {
  constexpr std::int64_t axis_mask = 0x1fffff;
  return (x >> fraction_bits) | (y >> 1 & axis_mask << 21) | (z << 20 & axis_mask << 42);
}

void sort_out(std::size_t from, std::size_t n, CornerSums& out) {
  WINNOW_INDEPENDENT
  for (std::size_t i = from; i < from + n; ++i) {
    const std::int64_t ax = out.place[0][0][i], ay = out.place[0][1][i], az = out.place[0][2][i];
    const std::int64_t bx = out.place[1][0][i], by = out.place[1][1][i], bz = out.place[1][2][i];
    const std::int64_t cx = out.place[2][0][i], cy = out.place[2][1][i], cz = out.place[2][2][i];
    out.cell[0][i] = packed(ax, ay, az);
    out.cell[1][i] = packed(bx, by, bz);
    out.cell[2][i] = packed(cx, cy, cz);
    const std::int64_t ab = (ax ^ bx) | (ay ^ by) | (az ^ bz);
    const std::int64_t ac = (ax ^ cx) | (ay ^ cy) | (az ^ cz);
    const std::int64_t bc = (bx ^ cx) | (by ^ cy) | (bz ^ cz);
    // Outside of the lattice, and where there is no number, bits above the 43 of a place are set.
    const std::int64_t any = (ax | ay | az) | (bx | by | bz) | (cx | cy | cz);
    const std::int64_t alone_or_three = (ac & ~fraction_mask) == 0   ? alone_b
                                        : (bc & ~fraction_mask) == 0 ? alone_a
                                                                     : three_cells;
    const std::int64_t with_c = (ac & ~fraction_mask) == 0 ? one_cell : alone_c;
    const std::int64_t cells = (ab & ~fraction_mask) == 0 ? with_c : alone_or_three;
    const std::int64_t apart = ab == 0   ? close_corners
                               : ac == 0 ? close_corners
                               : bc == 0 ? close_corners
                                         : cells;
    out.kind[i] = (any & ~((std::int64_t{1} << 43) - 1)) != 0 ? outside : apart;
  }
}

// Rounded up, so that no corner vanishes, and limited, so that no face overflows a sum by itself.
inline std::int32_t weight_of(float area, std::int32_t& clamped) {
  const float units = area * area_scale;
  clamped |= units >= weight_limit ? 1 : 0;
  const float limited = units < weight_limit ? units : weight_limit;
  const auto down = static_cast<std::int32_t>(limited);
  const std::int32_t up = down + (static_cast<float>(down) < limited ? 1 : 0);
  return up < 1 ? 1 : up;
}

struct Flags {
  std::int32_t clamped = 0, far = 0;
};

void weigh_corners(std::size_t from, std::size_t n, Scratch& s, CornerSums& out, Flags& flags) {
  std::int32_t clamped = 0;
  std::int32_t far = 0;
  WINNOW_INDEPENDENT
  for (std::size_t i = 0; i < n; ++i) {
    const float abx = s.ab[0][i], aby = s.ab[1][i], abz = s.ab[2][i];
    const float acx = s.ac[0][i], acy = s.ac[1][i], acz = s.ac[2][i];
    const float bcx = s.bc[0][i], bcy = s.bc[1][i], bcz = s.bc[2][i];
    const float nx = aby * acz - abz * acy;
    const float ny = abz * acx - abx * acz;
    const float nz = abx * acy - aby * acx;
    const float doubled_area = sqrtf(nx * nx + ny * ny + nz * nz);
    const float reciprocal = doubled_area > 0 ? 1 / doubled_area : 0.0F;
    const float ab = abx * abx + aby * aby + abz * abz;
    const float ac = acx * acx + acy * acy + acz * acz;
    const float dot_a = abx * acx + aby * acy + abz * acz;
    const float dot_b = -(abx * bcx + aby * bcy + abz * bcz);
    const float dot_c = acx * bcx + acy * bcy + acz * bcz;
    const float bc = bcx * bcx + bcy * bcy + bcz * bcz;
    far |= ((ab > far_square) | (ac > far_square) | (bc > far_square)) ? 1 : 0;
    // cot X = dot_x / doubled_area.
    const float eighth = reciprocal * 0.125F;
    const float from_a = bc * dot_a;
    const float from_b = ac * dot_b;
    const float from_c = ab * dot_c;
    const float half = doubled_area * 0.25F;      // half the area
    const float quarter = doubled_area * 0.125F;  // a quarter of it
    const bool obtuse = (dot_a < 0) | (dot_b < 0) | (dot_c < 0);
    const float a = obtuse ? (dot_a < 0 ? half : quarter) : (from_c + from_b) * eighth;
    const float b = obtuse ? (dot_b < 0 ? half : quarter) : (from_c + from_a) * eighth;
    const float c = obtuse ? (dot_c < 0 ? half : quarter) : (from_b + from_a) * eighth;
    // No corner has more than half of the area; of a needle, rounding could give it more.
    out.weight[0][from + i] = weight_of(a < half ? a : half, clamped);
    out.weight[1][from + i] = weight_of(b < half ? b : half, clamped);
    out.weight[2][from + i] = weight_of(c < half ? c : half, clamped);
    const float ux = nx * reciprocal, uy = ny * reciprocal, uz = nz * reciprocal;
    s.normal[0][i] = ux;
    s.normal[1][i] = uy;
    s.normal[2][i] = uz;
    out.normal[0][from + i] = rounded(ux * normal_scale);
    out.normal[1][from + i] = rounded(uy * normal_scale);
    out.normal[2][from + i] = rounded(uz * normal_scale);
  }
  flags.clamped |= clamped;
  flags.far |= far;
}

// The part of a place within its cell, as a double.
inline double fraction_of(std::int64_t place) {
  return double_of((place & fraction_mask) | whole_bits) - whole;
}

void add_up(std::size_t from, std::size_t n, CornerSums& out) {
  // Every product and sum here is a whole number below 2^52: exact.
  WINNOW_INDEPENDENT
  for (std::size_t i = from; i < from + n; ++i) {
    const double wa = out.weight[0][i];
    const double wb = out.weight[1][i];
    const double wc = out.weight[2][i];
    const double w = wa + wb + wc;
    const double x = wa * fraction_of(out.place[0][0][i]) + wb * fraction_of(out.place[1][0][i]) +
                     wc * fraction_of(out.place[2][0][i]);
    const double y = wa * fraction_of(out.place[0][1][i]) + wb * fraction_of(out.place[1][1][i]) +
                     wc * fraction_of(out.place[2][1][i]);
    const double z = wa * fraction_of(out.place[0][2][i]) + wb * fraction_of(out.place[1][2][i]) +
                     wc * fraction_of(out.place[2][2][i]);
    out.total_weight[i] = nearest_whole_from_zero(w);
    out.total_position[0][i] = nearest_whole_from_zero(x);
    out.total_position[1][i] = nearest_whole_from_zero(y);
    out.total_position[2][i] = nearest_whole_from_zero(z);
    out.total_normal[0][i] = nearest_whole(w * out.normal[0][i]);
    out.total_normal[1][i] = nearest_whole(w * out.normal[1][i]);
    out.total_normal[2][i] = nearest_whole(w * out.normal[2][i]);
  }
}

// The plane seen from the middle of a corner's cell: there |distance| is below 0.87 cells, so every
// number fits beside the normal's.
void find_planes(std::size_t from, std::size_t n, const Scratch& s, CornerSums& out) {
  for (std::size_t i = 0; i < n; ++i) {
    const float x = s.normal[0][i], y = s.normal[1][i], z = s.normal[2][i];
    out.squares[0][from + i] = rounded(x * x * normal_scale);
    out.squares[1][from + i] = rounded(x * y * normal_scale);
    out.squares[2][from + i] = rounded(x * z * normal_scale);
    out.squares[3][from + i] = rounded(y * y * normal_scale);
    out.squares[4][from + i] = rounded(y * z * normal_scale);
  }
  constexpr float to_cells = 1.0F / (1 << fraction_bits);
  for (std::size_t corner = 0; corner < 3; ++corner) {
    for (std::size_t i = 0; i < n; ++i) {
      const float x = s.normal[0][i], y = s.normal[1][i], z = s.normal[2][i];
      const float px = static_cast<float>(static_cast<std::int32_t>(out.place[corner][0][from + i] &
                                                                    fraction_mask)) *
                           to_cells -
                       0.5F;
      const float py = static_cast<float>(static_cast<std::int32_t>(out.place[corner][1][from + i] &
                                                                    fraction_mask)) *
                           to_cells -
                       0.5F;
      const float pz = static_cast<float>(static_cast<std::int32_t>(out.place[corner][2][from + i] &
                                                                    fraction_mask)) *
                           to_cells -
                       0.5F;
      const float distance = x * px + y * py + z * pz;
      out.moment[corner][0][from + i] = rounded(distance * x * normal_scale);
      out.moment[corner][1][from + i] = rounded(distance * y * normal_scale);
      out.moment[corner][2][from + i] = rounded(distance * z * normal_scale);
    }
  }
}

void add_up_planes(std::size_t from, std::size_t n, CornerSums& out) {
  WINNOW_INDEPENDENT
  for (std::size_t i = from; i < from + n; ++i) {
    const double wa = out.weight[0][i];
    const double wb = out.weight[1][i];
    const double wc = out.weight[2][i];
    const double w = wa + wb + wc;
    for (std::size_t k = 0; k < 5; ++k)
      out.total_squares[k][i] = nearest_whole(w * out.squares[k][i]);
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const double sum =
          wa * out.moment[0][axis][i] + wb * out.moment[1][axis][i] + wc * out.moment[2][axis][i];
      out.total_moment[axis][i] = nearest_whole(sum);
    }
  }
}

// A place in 2^-16 cells, as a double.
inline double side_steps(std::int64_t place) {
  constexpr int dropped = fraction_bits - side_bits;
  return double_of(static_cast<std::int64_t>(static_cast<std::uint64_t>(place) >> dropped) |
                   whole_bits);
}

// Exact for sides that are not far: products of whole numbers below 2^20.
void multiply_sides(std::size_t from, std::size_t n, CornerSums& out) {
  WINNOW_INDEPENDENT
  for (std::size_t i = from; i < from + n; ++i) {
    const double ax = side_steps(out.place[0][0][i]);
    const double ay = side_steps(out.place[0][1][i]);
    const double az = side_steps(out.place[0][2][i]);
    const double ux = side_steps(out.place[1][0][i]) - ax;
    const double uy = side_steps(out.place[1][1][i]) - ay;
    const double uz = side_steps(out.place[1][2][i]) - az;
    const double vx = side_steps(out.place[2][0][i]) - ax;
    const double vy = side_steps(out.place[2][1][i]) - ay;
    const double vz = side_steps(out.place[2][2][i]) - az;
    out.doubled_area[0][i] = nearest_whole(uy * vz - uz * vy);
    out.doubled_area[1][i] = nearest_whole(uz * vx - ux * vz);
    out.doubled_area[2][i] = nearest_whole(ux * vy - uy * vx);
  }
}

}  // namespace

void WINNOW_JOIN(corner_kernel_, WINNOW_KERNEL)(const KernelInput& input, CornerSums& out) {
  // Whole vectors: the faces beyond the last are computed too, and not looked at.
  const std::size_t all = (input.count + 15) / 16 * 16;
  Scratch scratch;
  Flags flags;
  for (std::size_t from = 0; from < all; from += block) {
    const std::size_t n = all - from < block ? all - from : block;
    if (input.single) {
      place_corners(input.single_position, input, from, n, scratch, out);
    } else {
      place_corners(input.position, input, from, n, scratch, out);
    }
    sort_out(from, n, out);
    weigh_corners(from, n, scratch, out, flags);
    add_up(from, n, out);
    if (input.quadrics) {
      find_planes(from, n, scratch, out);
      add_up_planes(from, n, out);
    }
    if (input.sides) multiply_sides(from, n, out);
  }
  out.clamped = flags.clamped != 0;
  out.far = flags.far != 0;
}

}  // namespace winnow
