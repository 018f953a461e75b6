// From corner positions to fixed-point contributions: the arithmetic that every face goes through.
//
// Weights: the mixed Voronoi area of each corner (Meyer, Desbrun, Schröder, Barr 2003), in units of 2^-24 of
// a cell's squared edge. The grid paper's formula prints |AC|^2 twice; it is
// (|AB|^2 cot C + |AC|^2 cot B) / 8 for a corner A of a triangle that is nowhere obtuse.
//
// This header is included by code for wider instruction sets, so it may not define functions: the linker
// could pick such a copy for everybody.
#pragma once

#include <cstddef>
#include <cstdint>

namespace winnow {

// 22 bits for a place within a cell or a part of a unit normal, 2^24 weight units a cell area, and at most 2^30
// units a corner (64 cell areas). A product has 52 bits; sums of products stay below 2^63 while the sum of
// weights stays below 2^41, which CellSum tests.
inline constexpr int fraction_bits = 22;
inline constexpr int area_bits = 24;
inline constexpr int weight_limit_bits = 30;

inline constexpr std::size_t kernel_capacity = 512;  // faces; that of FaceBatch

enum FaceKind : std::uint8_t {
  one_cell = 0,        // all corners in one cell
  several_cells = 1,
  repeated_corner = 2,  // two corners at the same position
  outside = 3,          // a corner that is not finite, or outside of the lattice
};

// Arrays side by side, indexed by face. `[corner]` and `[axis]` come before it.
struct CornerSums {
  alignas(64) std::uint64_t cell[3][kernel_capacity];  // PackedCell
  alignas(64) std::int32_t weight[3][kernel_capacity];
  alignas(64) std::int32_t fraction[3][3][kernel_capacity];  // place within the corner's cell, 0 to 2^22
  alignas(64) std::int32_t normal[3][kernel_capacity];       // unit normal times 2^22; 0 without area
  alignas(64) std::uint8_t kind[kernel_capacity];            // FaceKind
  // Sums over the three corners, for faces of one cell.
  alignas(64) std::int64_t total_weight[kernel_capacity];
  alignas(64) std::int64_t total_position[3][kernel_capacity];
  alignas(64) std::int64_t total_normal[3][kernel_capacity];
  bool clamped;  // a weight reached the limit, maybe in a face beyond the last

  // Only where quadrics were asked for: the plane of the face, seen from the middle of each corner's cell.
  alignas(64) std::int32_t squares[5][kernel_capacity];    // nx nx, nx ny, nx nz, ny ny, ny nz, times 2^22
  alignas(64) std::int32_t moment[3][3][kernel_capacity];  // [corner][axis]: distance times normal, times 2^22
};

struct KernelInput {
  const double* position[3][3];  // [corner][axis], aligned to 64 bytes, readable to a multiple of 16 faces
  std::size_t count;
  double origin[3];
  double inverse;
  bool quadrics;
};

using CornerKernel = void (*)(const KernelInput&, CornerSums&);

// The same function three times; all give the same bits.
void corner_kernel_baseline(const KernelInput& input, CornerSums& out);
void corner_kernel_avx2(const KernelInput& input, CornerSums& out);
void corner_kernel_avx512(const KernelInput& input, CornerSums& out);

// The widest that this processor runs.
CornerKernel best_corner_kernel();

}  // namespace winnow
