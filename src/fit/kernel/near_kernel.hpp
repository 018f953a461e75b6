// Which of some faces are nearest to some points. As cluster/kernel/corner_kernel.hpp: compiled
// once for each instruction set, the same results from all, and no function may be defined here.
#pragma once

#include <cstddef>
#include <cstdint>

namespace winnow {

// A face in a plane of its own: the first corner at (0, 0), the second at (second, 0).
struct FlatFace {
  float along[3], across[3], up[3];  // the axes, of length 1
  float second;
  float third[2];
  float side;  // along the first axis from the second to the third, as exact as floats are
  // 1 / the squared length of the sides from the first and the second corner to the third; 0 where
  // there is none.
  float by_first_side, by_second_side;
  float reach;  // of the farthest corner
};

// A face beside points: its first corner as they see it.
struct FaceBeside {
  FlatFace face;
  float corner[3];
};

// Points as they are seen from their middle, and what is known of the faces near them.
struct PointGroup {
  static constexpr std::size_t capacity = 32;
  static constexpr std::size_t lanes = 16;

  float place[3][capacity];
  float least[capacity];  // squared distance of the nearest face
  float next[capacity];   // and of the second nearest
  std::int32_t nearest[capacity];
};

// Looks at `faces` faces, which count from `first`. `count`: of points, a multiple of the lanes.
// The largest of the points' least squared distances.
using NearKernel = float (*)(PointGroup& points, std::size_t count, const FaceBeside* face,
                             std::size_t faces, std::int32_t first);

float near_kernel_baseline(PointGroup& points, std::size_t count, const FaceBeside* face,
                           std::size_t faces, std::int32_t first);
float near_kernel_avx2(PointGroup& points, std::size_t count, const FaceBeside* face,
                       std::size_t faces, std::int32_t first);
float near_kernel_avx512(PointGroup& points, std::size_t count, const FaceBeside* face,
                         std::size_t faces, std::int32_t first);

}  // namespace winnow
