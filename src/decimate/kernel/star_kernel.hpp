// How the faces around an edge turn when it is collapsed, the planes that they are in, for
// quadrics, and how far a point is from them. As edge_kernel.hpp: compiled once for each
// instruction set, the same results from all, and no function may be defined here.
#pragma once

#include <cstddef>

namespace winnow {

// Faces of which one corner moves, one array for each number.
struct StarBatch {
  static constexpr std::size_t capacity = 16;

  double to[3];                                    // where the corners go
  double from[3][capacity];                        // where each is
  double second[3][capacity], third[3][capacity];  // the corners that stay, in their winding
  double stays[capacity];                          // 1, or 0 for a face that goes

  // Results. Of the plane n, as long as 1, of each face that stays a third of its area * n n' (xx,
  // xy, xz, yy, yz, zz; zeros where it is thinner than rounding), and how much that is more than
  // the same of the face as it was.
  double planes[6][capacity], change[6][capacity];
  double turned[capacity];  // 1 where a face turns too far, or becomes a line; else 0
  double opened[capacity];  // 1 where a face that was thinner than rounding no longer is; else 0
};

// `least_cosine`: of the angle that a face may turn by. `rounding`, `absolute`: how far a
// coordinate may be off, beside its size and whatever that is, by the rule of base/rounding.hpp.
struct StarRules {
  double least_cosine;
  double rounding;
  double absolute = 0;
  bool planes = true;  // whether planes and change are wanted
};

// Of the first `count` faces; results of those behind, up to the next multiple of
// `star_kernel_lanes`, are without meaning.
using StarKernel = void (*)(StarBatch& batch, std::size_t count, const StarRules& rules);
inline constexpr std::size_t star_kernel_lanes = 8;

// Of faces as they are, whose corners are `from`, `second` and `third`: `planes`, as of one that
// stays.
using PlaneKernel = StarKernel;

// The squares of the distances of two points from the faces that stay, as they will be, where a
// point lies above or below the face: in each lane the least of these and of what is there.
using DistanceKernel = void (*)(const StarBatch& batch, std::size_t count,
                                const double (&points)[2][3],
                                double (&least)[2][star_kernel_lanes]);

void star_kernel_baseline(StarBatch& batch, std::size_t count, const StarRules& rules);
void star_kernel_avx2(StarBatch& batch, std::size_t count, const StarRules& rules);
void star_kernel_avx512(StarBatch& batch, std::size_t count, const StarRules& rules);

void plane_kernel_baseline(StarBatch& batch, std::size_t count, const StarRules& rules);
void plane_kernel_avx2(StarBatch& batch, std::size_t count, const StarRules& rules);
void plane_kernel_avx512(StarBatch& batch, std::size_t count, const StarRules& rules);

void distance_kernel_baseline(const StarBatch& batch, std::size_t count,
                              const double (&points)[2][3], double (&least)[2][star_kernel_lanes]);
void distance_kernel_avx2(const StarBatch& batch, std::size_t count, const double (&points)[2][3],
                          double (&least)[2][star_kernel_lanes]);
void distance_kernel_avx512(const StarBatch& batch, std::size_t count, const double (&points)[2][3],
                            double (&least)[2][star_kernel_lanes]);

}  // namespace winnow
