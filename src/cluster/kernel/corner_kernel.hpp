// From corner positions to fixed-point contributions: the arithmetic that every face goes through.
//
// Weights: the mixed Voronoi area of each corner (Meyer, Desbrun, Schröder, Barr 2003), in units of
// 2^-24 of a cell's squared edge. The grid paper's formula prints |AC|^2 twice; it is
// (|AB|^2 cot C + |AC|^2 cot B) / 8 for a corner A of a triangle that is nowhere obtuse.
//
// This header is included by code for wider instruction sets, so it may not define functions: the
// linker could pick such a copy for everybody.
#pragma once

#include <cstddef>
#include <cstdint>

namespace winnow {

// A place on the lattice is a whole number of 2^-22 cells, 43 bits an axis. Unit normals have 20
// bits. Weights count 2^-24 cell areas, at most 2^28 of them a corner (16 cell areas). A product of
// weight and fraction has 50 bits, and three of them still fit a double exactly; sums of products
// stay below 2^63 while the sum of weights stays below 2^41, which CellSum tests.
inline constexpr int fraction_bits = 22;
inline constexpr int normal_bits = 20;
inline constexpr int area_bits = 24;
inline constexpr int weight_limit_bits = 28;

// Sides, whose sums tell where the boundary runs, are whole numbers of 2^-16 cells.
inline constexpr int side_bits = 16;

inline constexpr std::size_t kernel_capacity = 128;  // faces; that of FaceBatch

enum FaceKind : std::int64_t {
  one_cell = 0,  // all corners in one cell
  // One corner in a cell, the other two in another: 1 + the corner that is alone.
  alone_a = 1,
  alone_b = 2,
  alone_c = 3,
  three_cells = 4,
  close_corners = 5,  // two corners at the same place of the lattice; maybe at the same position
  outside = 6,        // a corner that is not finite, or outside of the lattice
};

// Arrays side by side, indexed by face. `[corner]` and `[axis]` come before it.
struct CornerSums {
  alignas(64) std::int64_t place[3][3][kernel_capacity];  // cell and fraction: 21 and 22 bits
  alignas(64) std::int64_t cell[3][kernel_capacity];      // PackedCell
  alignas(64) std::int64_t kind[kernel_capacity];         // FaceKind
  alignas(64) std::int32_t weight[3][kernel_capacity];
  alignas(64) std::int32_t normal[3][kernel_capacity];  // unit normal times 2^20; 0 without area
  // Sums over the three corners.
  alignas(64) std::int64_t total_weight[kernel_capacity];
  alignas(64) std::int64_t total_position[3][kernel_capacity];
  alignas(64) std::int64_t total_normal[3][kernel_capacity];
  bool clamped;  // a weight reached the limit, maybe in a face beyond the last
  bool far;      // a side is longer than 7 cells, maybe of a face beyond the last

  // Only where quadrics were asked for: the plane of the face, seen from the middle of each
  // corner's cell.
  alignas(64)
      std::int32_t squares[5][kernel_capacity];  // nx nx, nx ny, nx nz, ny ny, ny nz, times 2^20
  alignas(64) std::int32_t
      moment[3][3][kernel_capacity];  // [corner][axis]: distance times normal, times 2^20
  // Sums over the three corners.
  alignas(64) std::int64_t total_squares[5][kernel_capacity];
  alignas(64) std::int64_t total_moment[3][kernel_capacity];

  // Only where sides were asked for, and no side is far: ab x ac, in squared 2^-16 cells.
  alignas(64) std::int64_t doubled_area[3][kernel_capacity];
};

struct KernelInput {
  // Either of float or of double: [corner][axis], aligned to 64 bytes, readable to a multiple of 16
  // faces.
  const float* single_position[3][3];
  const double* position[3][3];
  bool single;
  std::size_t count;
  double origin[3];
  double inverse;
  bool quadrics;
  bool sides;
};

using CornerKernel = void (*)(const KernelInput&, CornerSums&);

// The same function three times; all give the same bits.
void corner_kernel_baseline(const KernelInput& input, CornerSums& out);
void corner_kernel_avx2(const KernelInput& input, CornerSums& out);
void corner_kernel_avx512(const KernelInput& input, CornerSums& out);

// The widest that this processor runs.
CornerKernel best_corner_kernel();

}  // namespace winnow
